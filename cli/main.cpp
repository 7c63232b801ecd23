#include "cli/program.h"

int main(int argc, char** argv) { return texbake::run_program(argc, argv); }
