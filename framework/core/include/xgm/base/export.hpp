// SPDX-License-Identifier: Apache-2.0
// Marks what the shared library shows. Everything else stays hidden.
#pragma once

#define XGM_API __attribute__((visibility("default")))
