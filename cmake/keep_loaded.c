// In builds with the address sanitizer, in place of the C library's: a leak inside a library that has been unloaded
// has no name any more by the time it is reported, so that lsan.supp could not tell Mesa's leaks from ours.
int dlclose(void* library) {
    (void)library;
    return 0;
}
