#include "libbake/content/select_contents.h"
