// Drench: wet cloth for Bullet Physics. Everything public in one include.
#pragma once

#include "drench/air.h"
#include "drench/fabric.h"
#include "drench/ledger.h"
#include "drench/moisture.h"
#include "drench/sheet.h"
#include "drench/water.h"
#include "drench/wet_cloth.h"
#include "drench/wet_laws.h"
