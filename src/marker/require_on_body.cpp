// SPDX-License-Identifier: Apache-2.0
#include "marker/require_on_body.h"

#include "jprim/base/error.h"

namespace jprim {

void requireOnBody(const Marker& marker, const std::string& label, const std::string& element) {
    if (!marker.isOnBody())
        throw Error(element,
                    label +
                        " is not on a body; construct it with a MobilizedBody that has been added to a "
                        "matter subsystem");
}

}  // namespace jprim
