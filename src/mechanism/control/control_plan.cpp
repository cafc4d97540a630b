// SPDX-License-Identifier: Apache-2.0
#include "mechanism/control/control_plan.h"

#include "base/format.h"

namespace jprim {
namespace {

void addStates(const Dataset& dataset, ControlPlan& plan) {
    for (const DiffStatement& s : dataset.diffs) {
        plan.diffs[s.id] = plan.states.size();
        plan.states.push_back(
            {fmt::format("DIFF/{}", s.id), s.where, s.ic.empty() ? 0 : s.ic[0], s.staticHold, &s, 0, 0});
    }
    for (size_t k = 0; k < plan.systems.size(); ++k) {
        const LinearSystem& system = plan.systems[k];
        plan.arrays[system.x].firstState = plan.states.size();
        for (int row = 0; row < system.numStates; ++row)
            plan.states.push_back({fmt::format("{} state {}", system.name, row + 1), system.where,
                                   system.initial[size_t(row)], system.staticHold, nullptr, k, row});
    }
}

int countElements(const ArrayStatement& s) {
    if (s.type == ArrayType::Inputs) return int(s.variables.size());
    return s.numbers.empty() ? s.size : int(s.numbers.size());
}

void addArrays(const Dataset& dataset, ControlPlan& plan) {
    for (const ArrayStatement& s : dataset.arrays) {
        plan.arrays[s.id].statement = &s;
        plan.arrays[s.id].size = countElements(s);
        if (s.type == ArrayType::States || s.type == ArrayType::Outputs) plan.arrays[s.id].size = -1;
    }
    for (size_t k = 0; k < plan.systems.size(); ++k) {
        const LinearSystem& system = plan.systems[k];
        plan.arrays[system.x].system = k;
        plan.arrays[system.x].size = system.numStates;
        if (system.y == 0) continue;
        plan.arrays[system.y].system = k;
        plan.arrays[system.y].size = system.numOutputs;
    }
}

// The arrays of a system that has a mistake tell nothing, but that is no other mistake.
template <class Statements>
void addFaultyArrays(const Statements& statements, ControlPlan& plan) {
    for (const auto& s : statements)
        for (const int id : {s.x, s.y})
            if (id != 0 && plan.arrays[id].size < 0) plan.faulty.insert(fmt::format("ARRAY/{}", id));
}

}  // namespace

ControlPlan planControl(const Dataset& dataset, const ReportMistake& report) {
    ControlPlan plan;
    plan.systems = makeLinearSystems(dataset, report);
    addArrays(dataset, plan);
    addStates(dataset, plan);
    addFaultyArrays(dataset.lses, plan);
    addFaultyArrays(dataset.tfsisos, plan);
    for (const PlantStatement& s : dataset.plantInputs) plan.plantInputs[s.id] = &s;
    for (const PlantStatement& s : dataset.plantOutputs) plan.plantOutputs[s.id] = &s;
    for (const SensorStatement& s : dataset.sensors) {
        plan.sensors[s.id] = plan.evaluates.size();
        plan.evaluates.push_back(s.evaluate.has_value());
    }
    for (const auto& [keyword, ids] : dataset.faulty)
        for (const int id : ids) plan.faulty.insert(fmt::format("{}/{}", keyword, id));
    // A system that could not be read may be the one that has an array.
    if (dataset.faulty.count("LSE") + dataset.faulty.count("TFSISO") + dataset.faulty.count("GSE") > 0)
        for (const auto& [id, array] : plan.arrays)
            if (array.size < 0) plan.faulty.insert(fmt::format("ARRAY/{}", id));
    return plan;
}

}  // namespace jprim
