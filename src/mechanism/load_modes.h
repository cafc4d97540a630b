// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_LOAD_MODES_H_
#define JPRIM_SRC_MECHANISM_LOAD_MODES_H_

#include <functional>
#include <string>
#include <unordered_map>

#include "jprim/dataset/dataset.h"
#include "jprim/flexible/modal_basis.h"

namespace jprim {

/// By the id of the FLEX_BODY.
using ModesOfBodies = std::unordered_map<int, ModalBasis>;

/// The modes of all flexible bodies whose files can be read, in SI; what is wrong with the others is reported.
ModesOfBodies loadModes(const Dataset& dataset,
                        const std::function<void(const SourcePosition&, const std::string&)>& reportError);

}  // namespace jprim

#endif
