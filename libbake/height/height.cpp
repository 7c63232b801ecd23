#include "libbake/base/image.h"
