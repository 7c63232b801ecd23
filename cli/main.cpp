#include "formats/bundle.h"
int main() { return 0; }
