// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_CONTROL_CONTROL_PLAN_H_
#define JPRIM_SRC_MECHANISM_CONTROL_CONTROL_PLAN_H_

#include <map>
#include <set>

#include "mechanism/control/linear_systems.h"

namespace jprim {

/// A state of a DIFF, or of an LSE or TFSISO.
struct PlannedState {
    std::string name;
    SourcePosition where;
    double initial = 0;
    bool staticHold = false;
    const DiffStatement* diff = nullptr;  ///< null if it is one of a linear system
    size_t system = 0;                    ///< its place among the systems
    int row = 0;                          ///< and its place in there
};

/// What functions can read of control systems: which ARRAY means what, and all states in one list. Nothing of it needs
/// any mechanics.
struct ControlPlan {
    struct Array {
        const ArrayStatement* statement = nullptr;
        size_t system = 0;      ///< of X and Y
        size_t firstState = 0;  ///< of X
        int size = 0;
    };

    std::vector<PlannedState> states;
    std::vector<LinearSystem> systems;
    std::map<int, size_t> diffs;  ///< places in `states`, by id
    std::map<int, Array> arrays;
    std::map<int, const PlantStatement*> plantInputs, plantOutputs;
    std::map<int, size_t> sensors;  ///< places in the dataset
    std::vector<bool> evaluates;    ///< of each sensor, whether it has EVALUATE
    /// "ARRAY/3": what cannot be read, because of a mistake that is known.
    std::set<std::string> faulty;
};

/// @param dataset  must outlive the plan
ControlPlan planControl(const Dataset& dataset, const ReportMistake& report);

}  // namespace jprim

#endif
