// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_OUTPUTS_H_
#define JPRIM_SRC_MECHANISM_OUTPUTS_H_

#include "mechanism/elements/element_context.h"
#include "mechanism/reporter.h"

/// @file
/// What is looked at by functions and by runs: variables, splines, control systems, requests, sensors.
namespace jprim {

/// Variables, splines and control systems for functions. Mistakes in a spline or a system are reported here, at its statement; every function that
/// uses it fails too.
[[nodiscard]] FunctionContext makeFunctionContext(const Dataset& dataset, const UnitSystem& units,
                                                  Reporter& reporter);

/// Before all elements, whose functions may read them; null if there is nothing to keep.
[[nodiscard]] ControlVariables* addControlVariables(const ControlPlan& plan, MechanismContents& contents);

/// The equations of all states; the elements have to be known.
[[nodiscard]] std::vector<MechanismState> makeStates(const ElementContext& context, Reporter& reporter);

/// Variables that nothing uses are checked as well; the elements have to be known.
void checkVariables(const ElementContext& context, Reporter& reporter);

[[nodiscard]] std::vector<MechanismRequest> makeRequests(const ElementContext& context, Reporter& reporter);
[[nodiscard]] std::vector<MechanismSensor> makeSensors(const ElementContext& context, Reporter& reporter);

}  // namespace jprim

#endif
