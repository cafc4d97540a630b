// SPDX-License-Identifier: Apache-2.0
// Constraints come first, then values given for joints and motions, then EXACT. Where all can be met at once one
// search does; otherwise searches for less say what is in the way.
#include "simulation/find_positions.h"

#include <algorithm>
#include <optional>
#include <set>

#include "analysis/scaled_equations.h"
#include "base/format.h"
#include "jprim/analysis/conflicts.h"
#include "jprim/analysis/constraint_report.h"
#include "simulation/assembly_conditions.h"
#include "simulation/equation_access.h"
#include "simulation/position_search.h"
#include "simulation/redundancy.h"

namespace jprim {

using SimTK::Real;
using SimTK::State;
using Equations = std::vector<ConstraintEquation>;

namespace {

constexpr Real Kept = 1e-6;     // of EXACT [sizes of the part, rad]: less is not noticed
constexpr Real Rounded = 1e-3;  // likewise: less comes from numbers written with few digits

// Errors [sizes of a part, rad] that come from numbers with few digits, if all that is left in the end is as small and
// the equations that have them depend on each other.
constexpr Real Contradiction = 1e-4;

constexpr double Dominant = PositionProblem::Dominant;

/// What a search has to meet, and how much it counts where that cannot be.
struct Demand {
    Equations equations;
    PositionConditions conditions;
    double emphasisOfEquations = 1;
    std::vector<double> emphasisOfConditions;
};

PositionConditions join(PositionConditions a, const PositionConditions& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

Equations leaveOutMotions(const Equations& all) {
    Equations some;
    std::copy_if(all.begin(), all.end(), std::back_inserter(some),
                 [](const ConstraintEquation& e) { return e.element.rfind("MOTION/", 0) != 0; });
    return some;
}

class PositionFinder {
public:
    PositionFinder(const Mechanism& mechanism, const AssemblyAim& aim, const State& given)
        : m_mechanism(mechanism), m_aim(aim), m_given(given) {
        mechanism.getSystem().realize(m_given, SimTK::Stage::Position);
        m_equations = selectHolonomic(mechanism.findEquations(m_given));
        if (aim.holdGiven) {
            m_initial = makeInitialConditions(mechanism, m_given);
            m_exact = makeExactConditions(mechanism);
        }
    }

    FoundPositions find(State& state) {
        const Demand all{m_equations, join(m_initial, m_exact), 1, {}};
        bool isMet = meet(all, state);
        if (!isMet && (all.conditions.empty() || !meet({m_equations, {}, 1, {}}, state))) {
            if (leaveOutContradictions(state)) return find(state);
            if (!meetOtherwise(state)) fail(state);
            isMet = all.conditions.empty();
        }
        if (!isMet && !meetInitial(state)) {
            if (leaveOutContradictions(state)) return find(state);
            failInitial(state);
        }
        if (isMet || m_exact.empty())
            approach(all, state);
        else
            m_found.yielded = yieldExact(state);
        requireLittleLeft(state);
        return m_found;
    }

private:
    // Of equations that can be met but for next to nothing, those that depend on others up to that; false if that is not
    // why they cannot be met.
    bool leaveOutContradictions(const State& nearest) {
        const Real left =
            PositionSearch(makeProblem({m_equations, {}, 1, {}}, true), m_given).calcWorst(nearest);
        if (left > Contradiction || !m_found.leftOut.empty()) return false;
        const ConstraintReport report = analyzeConstraints(m_mechanism.getMatter(), nearest);
        std::set<int> dependent;
        for (const int k : selectRedundant(report, DropChoice::Later))
            dependent.insert(report.equations[size_t(k)].multiplier);
        Equations kept, others;
        State given = m_given;
        for (const ConstraintEquation& equation : m_equations) {
            const bool isKept = dependent.count(equation.multiplier) == 0;
            (isKept ? kept : others).push_back(equation);
            if (!isKept) EquationAccess(m_mechanism, equation).setScale(given, 0);
        }
        State met = given;
        if (!PositionSearch(makeProblem({kept, {}, 1, {}}, true), given).meetEquations(met)) return false;
        m_all = {m_equations, m_given};
        m_given = given;
        m_mechanism.getSystem().realize(m_given, SimTK::Stage::Position);
        m_equations = kept;
        m_found.leftOut = others;
        return true;
    }

    PositionProblem makeProblem(const Demand& demand, bool bends) const {
        std::vector<PoseGoal> poses;
        std::vector<SimTK::MobilizedBodyIndex> carriers;
        const auto& parts = m_mechanism.getParts();
        for (size_t k = 0; k < parts.size(); ++k) {
            if (parts[k].ground) continue;
            poses.push_back({parts[k].body.getMobilizedBodyIndex(), m_aim.poses[k], parts[k].size, 1});
            if (parts[k].flexible && !bends)
                carriers.insert(carriers.end(), parts[k].flexible->getCarriers().begin(),
                                parts[k].flexible->getCarriers().end());
        }
        const SimTK::SimbodyMatterSubsystem& matter = m_mechanism.getMatter();
        return {matter,
                Closeness(matter, poses),
                demand.equations,
                demand.conditions,
                demand.emphasisOfEquations,
                demand.emphasisOfConditions,
                carriers,
                m_aim.tolerance};
    }

    bool isFlexible() const {
        const auto& parts = m_mechanism.getParts();
        return std::any_of(parts.begin(), parts.end(),
                           [](const MechanismPart& p) { return bool(p.flexible); });
    }

    // From the given positions; the state is as near as it came. Where equations are left out, what is kept may be met
    // elsewhere too: the search begins where all are met best.
    bool meet(const Demand& demand, State& state) const {
        state = m_given;
        if (m_all) state.updQ() = findBest(demand.conditions).getQ();
        if (PositionSearch(makeProblem(demand, false), state).meetEquations(state)) return true;
        if (!isFlexible()) return false;
        state = m_given;
        return PositionSearch(makeProblem(demand, true), state).meetEquations(state);
    }

    State findBest(const PositionConditions& conditions) const {
        State state = m_all->given;
        PositionSearch(makeProblem({m_all->equations, conditions, 1, {}}, true), m_all->given)
            .meetEquations(state);
        return state;
    }

    // What is left out must not be missed by more than what was the reason.
    void requireLittleLeft(const State& state) const {
        if (!m_all) return;
        State all = m_all->given;
        all.updQ() = state.getQ();
        const PositionSearch search(makeProblem({m_all->equations, {}, 1, {}}, true), m_all->given);
        if (search.calcWorst(all) > Contradiction) fail(all);
    }

    // If they are not met the state is as near as the first search came.
    bool meetInitial(State& state) const {
        if (meet({m_equations, m_initial, 1, {}}, state)) return true;
        State other;
        if (!meet({m_equations, m_initial, Dominant, {}}, other) && !follow(m_initial, other)) return false;
        state = other;
        return true;
    }

    // In small steps along the equations, from where these are met.
    bool follow(const PositionConditions& conditions, State& state) const {
        constexpr int Steps = 20;
        State start;
        meet({m_equations, {}, 1, {}}, start);
        state = start;
        for (int k = 1; k <= Steps; ++k) {
            Demand demand{m_equations, {}, 1, {}};
            for (const auto& condition : conditions)
                demand.conditions.push_back(
                    std::make_shared<KeptCondition>(condition, start, 1 - Real(k) / Steps));
            if (!PositionSearch(makeProblem(demand, hasBent(state)), state).meetEquations(state))
                return false;
        }
        return true;
    }

    // By the search that explains failures: it must not find what this one does not, nor something else to be left.
    bool meetOtherwise(State& state) const {
        state = findConflicts(m_mechanism.getMatter(), m_given).state;
        return PositionSearch(makeProblem({m_equations, {}, 1, {}}, true), m_given).isMet(state);
    }

    // Along what is met; modes that were not needed stay.
    void approach(const Demand& demand, State& state) const {
        PositionSearch(makeProblem(demand, hasBent(state)), m_given).approachGoals(state);
    }

    bool hasBent(const State& state) const {
        for (const MechanismPart& part : m_mechanism.getParts())
            if (part.flexible &&
                (part.flexible->getModalCoordinates(state) - part.flexible->getModalCoordinates(m_given))
                        .normInf() > 0)
                return true;
        return false;
    }

    [[noreturn]] void fail(const State& state, const std::vector<MissedCoordinate>& missed = {},
                           const std::string& held = "") const {
        m_mechanism.getSystem().realize(state, SimTK::Stage::Position);
        const Violation left = calcViolation(m_mechanism, state);
        throw AssemblyError(
            left.element.empty() ? "assembly" : left.element,
            fmt::format(
                "the parts cannot be assembled from their given positions; an error of {:.3g} length units "
                "of the dataset and {:.3g} rad is left{}",
                left.length / m_mechanism.getUnits().length, left.angle, held),
            missed, state);
    }

    [[noreturn]] void failInitial(State& state) const {
        meet({m_equations, m_initial, Dominant, {}}, state);
        const std::vector<MissedCoordinate> missed = findMissedInitial(m_mechanism, state, AssemblyTolerance);
        if (missed.empty()) fail(state);
        throw AssemblyError(
            missed[0].element,
            fmt::format("its initial value contradicts the constraints or other given coordinates; the "
                        "nearest that can be assembled misses it by {}",
                        formatAmount(missed[0], m_mechanism.getUnits())),
            missed, state);
    }

    // The EXACT coordinates come as near as the others let them, and stay there.
    std::vector<MissedCoordinate> yieldExact(State& state) const {
        const PositionConditions conditions = join(m_initial, m_exact);
        std::vector<double> emphasis(conditions.size(), 1);
        std::fill_n(emphasis.begin(), m_initial.size(), Dominant);
        meet({m_equations, conditions, Dominant, emphasis}, state);
        const Demand others{m_equations, m_initial, 1, {}};
        if (!PositionSearch(makeProblem(others, hasBent(state)), state).meetEquations(state))
            failExact(state);
        const std::vector<MissedCoordinate> missed = findMissedExact(m_mechanism, state, Kept);
        State without;
        if (!findMissedExact(m_mechanism, state, Rounded).empty() &&
            !meet({leaveOutMotions(m_equations), m_exact, 1, {}}, without))
            failExact(state);
        Demand reached = others;
        for (const auto& exact : m_exact)
            reached.conditions.push_back(std::make_shared<KeptCondition>(exact, state));
        approach(reached, state);
        return missed;
    }

    [[noreturn]] void failExact(const State& withoutExact) const {
        const std::vector<MissedCoordinate> missed = findMissedExact(m_mechanism, withoutExact, Kept);
        const PositionConditions conditions = join(m_initial, m_exact);
        State state;
        meet({m_equations, conditions, 1, std::vector<double>(conditions.size(), Dominant)}, state);
        std::string held = fmt::format(", with {} held", nameHeld(m_mechanism));
        if (!missed.empty())
            held += fmt::format("; the nearest without EXACT has {} of {} elsewhere by {}",
                                missed[0].coordinate.substr(std::string("EXACT ").size()), missed[0].element,
                                formatAmount(missed[0], m_mechanism.getUnits()));
        fail(state, missed, held);
    }

    const Mechanism& m_mechanism;
    const AssemblyAim& m_aim;
    State m_given;
    Equations m_equations;
    PositionConditions m_initial, m_exact;
    FoundPositions m_found;

    /// Before any were left out.
    struct All {
        Equations equations;
        State given;
    };
    std::optional<All> m_all;
};

}  // namespace

FoundPositions findPositions(const Mechanism& mechanism, const AssemblyAim& aim, State& state) {
    FoundPositions found = PositionFinder(mechanism, aim, state).find(state);
    mechanism.getSystem().realize(state, SimTK::Stage::Position);
    return found;
}

}  // namespace jprim
