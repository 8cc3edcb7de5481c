// SPDX-License-Identifier: Apache-2.0
// The owner of the precompiled header that all test programs share; it has no code of its own.
