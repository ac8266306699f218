// The umbrella header of lpquad::lpquad_io: domains and surfaces from the text of files, meshes and
// reports to such text.
#pragma once

#include "io/domain/domain_format.h"
#include "io/error_text.h"
#include "io/mesh/mesh_format.h"
#include "io/report.h"
#include "io/surface/surface_format.h"
#include "io/surface_report.h"
