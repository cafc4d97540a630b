// SPDX-License-Identifier: Apache-2.0
#include "jprim/dataset/dataset.h"

#include "dataset/statement_kind.h"
#include "dataset/statements/ignored.h"

namespace jprim {

bool operator==(const Dataset& a, const Dataset& b) {
    const std::vector<StatementKind>& kinds = getStatementKinds();
    return a.title == b.title && areIgnoredEqual(a, b) &&
           std::all_of(kinds.begin(), kinds.end(),
                       [&](const StatementKind& kind) { return !kind.equal || kind.equal(a, b); });
}

bool operator!=(const Dataset& a, const Dataset& b) {
    return !(a == b);
}

}  // namespace jprim
