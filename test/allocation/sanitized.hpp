// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_TEST_SANITIZED_HPP
#define GMLPNP_TEST_SANITIZED_HPP

/** Whether a sanitizer has taken the place of malloc: then nothing can be counted or made to fail. */
#if defined(__has_feature)  // clang's way to say so
#define SANITIZED (__has_feature(address_sanitizer) || __has_feature(thread_sanitizer))
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SANITIZED 1
#else
#define SANITIZED 0
#endif

#endif  // GMLPNP_TEST_SANITIZED_HPP
