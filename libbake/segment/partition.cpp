#include "libbake/segment/partition.h"
