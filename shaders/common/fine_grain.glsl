// SPDX-License-Identifier: Apache-2.0
// Is the grain of floors and colliders drawn?
#ifdef SHADOW_DRAFT
const bool kFineGrain = false;  // software renderers pay for it in every pixel
#else
const bool kFineGrain = true;
#endif
