// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_TOOL_CHECK_REPORT_H_
#define JPRIM_SRC_TOOL_CHECK_REPORT_H_

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "jprim/analysis/conflicts.h"
#include "jprim/analysis/constraint_report.h"
#include "jprim/simulation/assemble.h"
#include "tool/commands.h"

namespace jprim::tool {

/// Where assembly failed: what is left at the best position found.
struct AssemblyFailure {
    std::string message;
    ConflictReport conflicts;
    std::vector<MissedCoordinate> missed;  ///< given coordinates that are in the way
    Violation left;
    std::vector<FlippedAxes> flipped;
};

/// How `jprim run` would solve the mechanism by a tree.
struct TreeReport {
    struct Branch {
        std::string part, parent;  ///< "PART/3"; the parent is "ground" of a part that no joint holds
        std::string mobilizer;     ///< Simbody's word
        std::vector<std::string> elements;  ///< that it stands for
    };
    std::vector<Branch> branches;
    std::vector<std::string> equations;  ///< "JOINT/4 REVOLUTE": those that close loops or fit no mobilizer
};

/// All that `jprim check` has to say, in the mechanism's units. Counts and equations are those of all joints, also
/// where a tree would do without them. A dataset with errors has a model without
/// mechanism and nothing else; one that cannot be assembled a failure and no assembled State.
struct CheckReport {
    Model model;
    /// How many there are of each kind of element and type: {"JOINT", {{"REVOLUTE", 4}}}.
    std::map<std::string, std::map<std::string, int>> elements;
    Violation given;
    std::optional<AssembledState> assembled;
    /// In the assembled position; if there is none, mobilities and equations are counted and no more, for
    /// freedoms of a position that does not exist mean nothing.
    ConstraintReport constraints;
    std::optional<AssemblyFailure> failure;
    std::optional<TreeReport> tree;  ///< of Formulation::Tree

    bool isUsable() const { return assembled.has_value(); }
};

/// @param model  in Formulation::Constraints
/// @param formulation  Tree: says too how a tree would be made
CheckReport makeCheckReport(Model model, Formulation formulation);

/// Its lines; only of a model with a mechanism.
std::vector<std::string> formatText(const CheckReport& report);
void printJson(const CheckReport& report);

}  // namespace jprim::tool

#endif
