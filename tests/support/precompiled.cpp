// SPDX-License-Identifier: Apache-2.0
// The owner of a precompiled header that test programs share; it has no code of its own.
