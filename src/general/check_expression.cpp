// SPDX-License-Identifier: Apache-2.0
#include "general/check_expression.h"

#include <algorithm>

#include "base/format.h"
#include "jprim/base/error.h"
#include "marker/require_on_body.h"

namespace jprim {

using SimTK::SimbodyMatterSubsystem;

std::string findValueProblem(KinematicLevel level, bool isLinearInVelocity) {
    if (level == KinematicLevel::Acceleration)
        return "a constraint cannot depend on accelerations or reactions; only on positions, velocities and TIME";
    if (!isLinearInVelocity)
        return "the expression is not linear in velocities; a constraint of velocities must be";
    return "";
}

std::string findEquationProblem(const MarkerExpression& expression) {
    const Program& program = expression.program;
    if (program.isVector()) return "the expression is a vector; write one equation for each component";
    const std::string problem = findValueProblem(program.getLevel(), program.isLinearInVelocity());
    if (!problem.empty()) return problem;
    if (expression.markers.empty()) return "the expression depends on no marker, so it constrains nothing";
    return expression.findDerivativeProblem(program.getLevel() == KinematicLevel::Position ? 2 : 1);
}

std::string findFunctionProblem(const MarkerExpression& expression) {
    if (expression.program.isVector()) return "the function is a vector; it must be a number";
    const bool onlyTime =
        expression.markers.empty() && expression.program.getLevel() == KinematicLevel::Position;
    return onlyTime ? "" : NotOnlyTime;
}

SimbodyMatterSubsystem& findMatter(const MarkerExpression& expression, const std::string& element) {
    const std::string problem = findEquationProblem(expression);
    if (!problem.empty()) throw Error(element, problem);
    const auto isOnGround = [](const Marker& marker) {
        return marker.isOnBody() && marker.getBody().isGround();
    };
    if (std::all_of(expression.markers.begin(), expression.markers.end(), isOnGround))
        throw Error(element, "all markers of the expression are on Ground, so it constrains nothing");
    for (size_t k = 0; k < expression.markers.size(); ++k) {
        requireOnBody(expression.markers[k], fmt::format("marker {}", expression.markerIds[k]), element);
        if (&expression.markers[k].getBody().getMatterSubsystem() !=
            &expression.markers[0].getBody().getMatterSubsystem())
            throw Error(element,
                        fmt::format("markers {} and {} belong to different systems; put all bodies into one",
                                    expression.markerIds[0], expression.markerIds[k]));
    }
    // Adding a constraint is what the caller asked for.
    return const_cast<SimbodyMatterSubsystem&>(expression.markers[0].getBody().getMatterSubsystem());
}

}  // namespace jprim
