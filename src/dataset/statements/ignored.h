// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_STATEMENTS_IGNORED_H_
#define JPRIM_SRC_DATASET_STATEMENTS_IGNORED_H_

#include "dataset/language/statement_reader.h"
#include "dataset/writer/statement_writer.h"

/// @file
/// All kinds that are ignored stand in one list of the dataset.
namespace jprim {

void readIgnored(StatementReader& reader);
void writeIgnored(StatementWriter& writer, const Dataset& dataset);
bool areIgnoredEqual(const Dataset& a, const Dataset& b);

}  // namespace jprim

#endif
