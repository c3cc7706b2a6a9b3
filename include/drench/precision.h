// For config.h.
#pragma once

#include "drench/config.h"
