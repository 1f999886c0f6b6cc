/*
 * Preloaded where leaks are looked for: libraries stay loaded to the end, so that what graphics
 * drivers leak can be told from our own leaks by the library's name (tests/lsan.supp).
 */
int dlclose(void *handle);

int dlclose(void *handle) {
    (void)handle;
    return 0;
}
