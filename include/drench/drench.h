// Drench: wet cloth for Bullet Physics. Everything public in one include.
#pragma once

#include "drench/air.h"
#include "drench/cloth_mesh.h"
#include "drench/drop.h"
#include "drench/drying.h"
#include "drench/fabric.h"
#include "drench/falling_drops.h"
#include "drench/ledger.h"
#include "drench/moisture.h"
#include "drench/sheet.h"
#include "drench/small_step_solver.h"
#include "drench/source.h"
#include "drench/sources.h"
#include "drench/water.h"
#include "drench/wet_cloth.h"
#include "drench/wet_contact.h"
#include "drench/wet_laws.h"
