// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_JPRIM_H_
#define JPRIM_JPRIM_H_

/// @file
/// All of jprim.

#include "jprim/analysis/conflicts.h"
#include "jprim/analysis/constraint_equations.h"
#include "jprim/analysis/constraint_report.h"
#include "jprim/base/diagnostic.h"
#include "jprim/base/error.h"
#include "jprim/base/units.h"
#include "jprim/build/build_mechanism.h"
#include "jprim/build/mechanism.h"
#include "jprim/dataset/commands.h"
#include "jprim/dataset/constraint_statements.h"
#include "jprim/dataset/dataset.h"
#include "jprim/dataset/force_statements.h"
#include "jprim/dataset/read_dataset.h"
#include "jprim/dataset/source_text.h"
#include "jprim/dataset/write_dataset.h"
#include "jprim/flexible/beam.h"
#include "jprim/flexible/finite_element_model.h"
#include "jprim/flexible/flexible_body.h"
#include "jprim/flexible/modal_basis.h"
#include "jprim/flexible/read_mesh.h"
#include "jprim/flexible/reduce_to_modes.h"
#include "jprim/force/expression_measure.h"
#include "jprim/force/marker_force.h"
#include "jprim/general/general_constraint.h"
#include "jprim/joint/joint.h"
#include "jprim/joint/motion.h"
#include "jprim/marker/angles.h"
#include "jprim/marker/expression.h"
#include "jprim/marker/load.h"
#include "jprim/marker/marker.h"
#include "jprim/marker/marker_pair.h"
#include "jprim/primitive/pair_constraint.h"
#include "jprim/primitive/primitive.h"
#include "jprim/primitive/primitives.h"
#include "jprim/simulation/assemble.h"
#include "jprim/simulation/equilibrium.h"
#include "jprim/simulation/results.h"
#include "jprim/simulation/run_commands.h"
#include "jprim/simulation/simulate.h"
#include "jprim/version.h"

#endif
