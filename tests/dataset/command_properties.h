// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_DATASET_COMMAND_PROPERTIES_H_
#define JPRIM_TESTS_DATASET_COMMAND_PROPERTIES_H_

#include <string>
#include <string_view>

#include "dataset/reader_properties.h"
#include "jprim/dataset/commands.h"

/// @file
/// What must hold for the commands of every text whatsoever; shared by the fuzzer and by the tests.
namespace jprim {

/// What a program that runs the commands may rely on.
inline bool isSound(const SimulateCommand& s) {
    const bool timed =
        s.end.has_value() != s.duration.has_value() && s.steps.has_value() != s.dtout.has_value();
    const bool untimed = !s.end && !s.duration && !s.steps && !s.dtout;
    if (s.end.value_or(1) <= 0 || s.duration.value_or(1) <= 0) return false;
    if (s.steps.value_or(1) < 1 || s.dtout.value_or(1) <= 0) return false;
    if (s.analysis == Analysis::InitialConditions) return untimed;
    if (s.analysis == Analysis::Statics && untimed) return true;
    return timed && s.level == KinematicLevel::Acceleration;
}

inline bool isSound(const ActivateCommand& a) {
    for (const IdRange& range : a.ids)
        if (range.first < 1 || range.first > range.last) return false;
    return !a.ids.empty();
}

/// The first property that reading these commands breaks; empty if it keeps them all.
inline std::string findBrokenCommandProperty(std::string_view text) {
    Diagnostics diagnostics;
    const CommandFile file = readCommands(text, diagnostics);
    const std::string misplaced = findMisplaced(text, diagnostics);
    if (!misplaced.empty()) return misplaced;
    for (const Command& command : file.commands)
        if (!std::visit([](const auto& c) { return isSound(c); }, command)) return "a command is not sound";
    if (!hasErrors(diagnostics) && (file.model.empty() || file.output.empty())) return "a name is empty";
    return {};
}

}  // namespace jprim

#endif
