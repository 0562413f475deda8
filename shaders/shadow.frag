// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Depth only.
void main() {}
