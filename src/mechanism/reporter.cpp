// SPDX-License-Identifier: Apache-2.0
#include "mechanism/reporter.h"

#include <algorithm>

#include "jprim/base/error.h"
#include "mechanism/function_writer.h"

namespace jprim {

bool Reporter::attempt(const std::string& element, const SourcePosition& where,
                       const std::function<void()>& build) {
    try {
        build();
        return true;
    } catch (const FunctionError& error) {
        addError(error.where, element + ": " + error.what());
    } catch (const Error& error) {
        addError(where, error.what());
    } catch (const std::exception& error) {  // Simbody's, which runs over several lines
        std::string text = error.what();
        std::replace(text.begin(), text.end(), '\n', ' ');
        addError(where, element + ": " + text);
    }
    return false;
}

}  // namespace jprim
