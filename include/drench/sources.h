// All water sources that come with Drench, except those that need Bullet (wet_contact.h). Each is constructed with its
// settings, which may be changed at any time. They are checked when the source is added and in every step: a value out
// of range throws std::invalid_argument that names it; see `Source::supply` for what follows from that.
#pragma once

#include "drench/brush.h"
#include "drench/pool.h"
#include "drench/rain.h"
#include "drench/soak.h"
#include "drench/spray.h"
