// One eye per draw, or both: then a vertex knows its eye by its instance, or by its view.
#ifndef STEREO_KEYWORDS_INCLUDED
#define STEREO_KEYWORDS_INCLUDED

#if defined(STEREO_INSTANCING_ON)
    #define UNITY_STEREO_INSTANCING_ENABLED
#elif defined(STEREO_MULTIVIEW_ON)
    #define UNITY_STEREO_MULTIVIEW_ENABLED
#endif
#if defined(UNITY_STEREO_INSTANCING_ENABLED) || defined(UNITY_STEREO_MULTIVIEW_ENABLED)
    #define USING_STEREO_MATRICES
#endif

#endif
