// SPDX-License-Identifier: Apache-2.0
extern "C" int countEquations();

int main() {
    return countEquations() == 3 ? 0 : 1;
}
