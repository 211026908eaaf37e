/* Every host here calls this once; 0 when all was well. `folder` may be
 * written to. */
#ifdef __cplusplus
extern "C"
#else
extern
#endif
int use_library(const char *folder);
