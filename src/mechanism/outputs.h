// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_OUTPUTS_H_
#define JPRIM_SRC_MECHANISM_OUTPUTS_H_

#include "mechanism/elements/element_context.h"
#include "mechanism/reporter.h"

/// @file
/// What is only looked at: functions, requests, sensors.
namespace jprim {

/// Variables and splines for functions. Mistakes in a spline are reported here, at its statement; every function that
/// uses it fails too.
[[nodiscard]] FunctionContext makeFunctionContext(const Dataset& dataset, const UnitSystem& units,
                                                  Reporter& reporter);

/// Variables that nothing uses are checked as well; the elements have to be known.
void checkVariables(const ElementContext& context, Reporter& reporter);

[[nodiscard]] std::vector<MechanismRequest> makeRequests(const ElementContext& context, Reporter& reporter);
[[nodiscard]] std::vector<MechanismSensor> makeSensors(const ElementContext& context, Reporter& reporter);

}  // namespace jprim

#endif
