#include "libbake/color/luv.h"
