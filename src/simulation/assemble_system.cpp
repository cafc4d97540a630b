// SPDX-License-Identifier: Apache-2.0
#include "jprim/simulation/assemble_system.h"

#include <algorithm>
#include <cmath>

#include "analysis/scaled_equations.h"
#include "base/format.h"
#include "jprim/base/error.h"
#include "jprim/simulation/assemble.h"
#include "simulation/position_search.h"

namespace jprim {

using SimTK::MobilizedBodyIndex;
using SimTK::SimbodyMatterSubsystem;
using SimTK::Stage;
using SimTK::State;

namespace {

void requireGood(const SimbodyMatterSubsystem& matter, const AssemblyGoals& goals) {
    const auto require = [](bool good, const std::string& what) {
        if (!good) throw Error("AssemblyGoals", what);
    };
    require(goals.staying > 0, fmt::format("staying is {}; it must be positive", goals.staying));
    require(goals.size > 0, fmt::format("size is {}; it must be positive", goals.size));
    const auto isThere = [&matter](MobilizedBodyIndex b) {
        return b.isValid() && b >= 0 && b < matter.getNumBodies();
    };
    for (const PoseGoal& goal : goals.poses) {
        require(isThere(goal.body), "a PoseGoal names a body that the system does not have");
        require(goal.size > 0 && goal.weight > 0,
                fmt::format("a PoseGoal has size {} and weight {}; both must be positive", goal.size,
                            goal.weight));
    }
    for (const MarkerGoal& goal : goals.markers) {
        require(goal.marker.isOnBody() &&
                    &goal.marker.getBody().getMatterSubsystem().getSystem() == &matter.getSystem(),
                "a MarkerGoal's marker is not on a body of the system");
        require(goal.weight >= 0,
                fmt::format("a MarkerGoal has weight {}; it must not be negative", goal.weight));
    }
    for (const MobilizedBodyIndex b : goals.locked)
        require(isThere(b), "a body to be locked is not in the system");
}

// With a goal for every body, so that no freedom is without one.
std::vector<PoseGoal> completePoses(const SimbodyMatterSubsystem& matter, const State& state,
                                    const AssemblyGoals& goals) {
    std::vector<PoseGoal> poses = goals.poses;
    for (MobilizedBodyIndex b(1); b < matter.getNumBodies(); ++b) {
        const bool hasGoal = std::any_of(goals.poses.begin(), goals.poses.end(),
                                         [b](const PoseGoal& goal) { return goal.body == b; });
        if (!hasGoal)
            poses.push_back(
                {b, matter.getMobilizedBody(b).getBodyTransform(state), goals.size, goals.staying});
    }
    return poses;
}

[[noreturn]] void fail(const std::vector<ConstraintEquation>& equations, const State& state) {
    const auto calcError = [&state](const ConstraintEquation& e) {
        return std::abs(state.getQErr()[e.multiplier]);
    };
    const auto worst =
        std::max_element(equations.begin(), equations.end(),
                         [&](const auto& a, const auto& b) { return calcError(a) < calcError(b); });
    throw Error(
        worst->element,
        fmt::format("the system cannot be assembled from these positions; {:.3g} {} of \"{}\" are left",
                    calcError(*worst), getUnitName(worst->dimension), worst->words));
}

}  // namespace

State assemble(const SimTK::MultibodySystem& system, const State& given, const AssemblyGoals& goals,
               const ElementNames& names) {
    const SimbodyMatterSubsystem& matter = system.getMatterSubsystem();
    State state = given;
    system.realize(state, Stage::Position);
    requireGood(matter, goals);
    const std::vector<ConstraintEquation> equations = selectHolonomic(findEquations(matter, state, names));
    PositionProblem problem{
        matter,      Closeness(matter, completePoses(matter, state, goals), goals.markers),
        equations,   {},
        1,           {},
        goals.locked};
    const PositionSearch search(std::move(problem), state);
    if (!search.meetEquations(state)) {
        system.realize(state, Stage::Position);
        fail(equations, state);
    }
    search.approachGoals(state);
    system.realize(state, Stage::Position);
    return state;
}

}  // namespace jprim
