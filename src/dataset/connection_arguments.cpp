// SPDX-License-Identifier: Apache-2.0
#include "dataset/connection_arguments.h"

#include "base/format.h"

namespace jprim {

void checkAllowed(StatementReader& reader, const char* name, bool allowed, const char* owners) {
    if (reader.has(name) && !allowed)
        reader.addError(reader.getOffset(name),
                        fmt::format("{} of {} is for {} only", name, reader.getName(), owners));
}

}  // namespace jprim
