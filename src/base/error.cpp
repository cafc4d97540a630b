// SPDX-License-Identifier: Apache-2.0
#include "jprim/base/error.h"

namespace jprim {

Error::Error(const std::string& element, const std::string& message)
    : std::runtime_error(element + ": " + message), m_element(element) {}

}  // namespace jprim
