// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace ribbon_mapper {

// The page of page/, put together by embed_page.py when the library is built. So a program needs no
// file to write a page, and page and data are always of one version.

/// Returns the page up to its data.
std::string_view page_before_data();

/// Returns the page after its data.
std::string_view page_after_data();

}  // namespace ribbon_mapper
