// The residuals of the lobe fit and their derivatives, apart from the solver.
#pragma once

#include <vector>

namespace texbake {

inline constexpr int kLobeParameters = 6;  ///< power, center x, center y, l_xx, l_xy, l_yy

/// One frequency of the table: what the magnitude sqrt(density) should be there.
struct LobeSample {
  double fx_cpp = 0;
  double fy_cpp = 0;
  double magnitude = 0;
};

/// residual[i] = sqrt(Σ lobes' density(f_i) + ε) − magnitude_i, ε = `floor`². `parameters` holds kLobeParameters for
/// each lobe. `jacobian` is null or a row-major matrix of samples × parameters.
void lobe_residuals(const std::vector<LobeSample>& samples, double floor, const double* parameters, int lobes,
                    double* residuals, double* jacobian);

}  // namespace texbake
