// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_COMMANDS_COMMAND_RULES_H_
#define JPRIM_SRC_DATASET_COMMANDS_COMMAND_RULES_H_

#include <cstddef>
#include <string_view>
#include <vector>

#include "dataset/language/statement_reader.h"
#include "jprim/dataset/commands.h"

namespace jprim {

/// Everything that is known while commands are read.
struct CommandState {
    CommandFile file;
    int modelLine = 0;  ///< where the model was named
};

/// A kind of command: its name, the letters that an abbreviation needs, and the function that reads it.
struct CommandRule {
    std::string_view name;
    std::size_t minimum = 1;
    void (*read)(StatementReader&, CommandState&) = nullptr;
};

/// Every kind of command that is supported, besides STOP and EXIT, which end the reading.
const std::vector<CommandRule>& getCommandRules();

}  // namespace jprim

#endif
