// SPDX-License-Identifier: Apache-2.0
#include "mechanism/load_modes.h"

#include <filesystem>

#include "base/format.h"
#include "jprim/base/error.h"

namespace jprim {

ModesOfBodies loadModes(const Dataset& dataset,
                        const std::function<void(const SourcePosition&, const std::string&)>& reportError) {
    ModesOfBodies modes;
    for (const FlexBodyStatement& body : dataset.flexBodies) {
        const std::filesystem::path file = std::filesystem::path(dataset.folder) / body.modesFile;
        try {
            modes[body.id] = loadModalBasis(file.string());
        } catch (const Error& error) {
            reportError(body.where, fmt::format("FLEX_BODY/{}: {}", body.id, error.what()));
        }
    }
    return modes;
}

}  // namespace jprim
