// SPDX-License-Identifier: Apache-2.0
#include "jprim/dataset/write_dataset.h"

#include "dataset/statement_kind.h"
#include "dataset/statements/ignored.h"

namespace jprim {

std::string writeDataset(const Dataset& dataset) {
    std::string text = dataset.title + "\n";
    StatementWriter writer(text);
    for (const StatementKind& kind : getStatementKinds())
        if (kind.write) kind.write(writer, dataset);
    writeIgnored(writer, dataset);
    return text + "END\n";
}

}  // namespace jprim
