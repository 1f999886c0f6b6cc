#include "cli/options.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void print_usage(const char *usage, const kg_option *options, size_t count) {
    printf("usage: %s\n", usage);
    if (count > 0)
        putchar('\n');
    for (size_t i = 0; i < count; i++) {
        char form[64];
        snprintf(form, sizeof form, "%c%c%s--%s%s%s", options[i].letter ? '-' : ' ',
                 options[i].letter ? options[i].letter : ' ', options[i].letter ? ", " : "  ",
                 options[i].name, options[i].has_value ? " " : "",
                 options[i].has_value ? options[i].value : "");
        printf("  %-28s %s\n", form, options[i].help);
    }
}

static const kg_option *find_option(const kg_option *options, size_t count, const char *word,
                                    size_t length) {
    for (size_t i = 0; i < count; i++) {
        bool is_long = word[1] == '-' && strlen(options[i].name) == length - 2 &&
                       strncmp(options[i].name, word + 2, length - 2) == 0;
        bool is_short = word[1] != '-' && length == 2 && word[1] == options[i].letter;
        if (is_long || is_short)
            return &options[i];
    }
    return NULL;
}

int kg_arguments_parse(int argc, char **argv, const char *usage, const kg_option *options,
                       size_t option_count, kg_arguments *out) {
    *out = (kg_arguments){.command = argv[0]};
    bool only_words = false;
    for (int i = 1; i < argc; i++) {
        const char *word = argv[i], *equals = strchr(word, '=');
        if (only_words || word[0] != '-' || word[1] == '\0') {
            if (out->count == (int)(sizeof out->words / sizeof *out->words))
                return kg_command_misuse(argv[0], "too many words: %s", word);
            out->words[out->count++] = word;
            continue;
        }
        if (strcmp(word, "--") == 0) {
            only_words = true;
            continue;
        }
        if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0) {
            print_usage(usage, options, option_count);
            return KG_EXIT_DONE;
        }
        size_t length = equals && word[1] == '-' ? (size_t)(equals - word) : strlen(word);
        const kg_option *option = find_option(options, option_count, word, length);
        if (!option)
            return kg_command_misuse(argv[0], "unknown option %s", word);
        const char *value = "";
        if (option->has_value) {
            value = word[length] == '=' ? equals + 1 : i + 1 < argc ? argv[++i] : NULL;
            if (!value)
                return kg_command_misuse(argv[0], "%s needs a value", word);
        } else if (word[length] == '=') {
            return kg_command_misuse(argv[0], "--%s takes no value", option->name);
        }
        if (out->given_count == (int)(sizeof out->given / sizeof *out->given))
            return kg_command_misuse(argv[0], "too many options");
        out->given[out->given_count].option = option;
        out->given[out->given_count++].value = value;
    }
    return -1;
}

const char *kg_arguments_get(const kg_arguments *arguments, const char *name) {
    for (int i = arguments->given_count - 1; i >= 0; i--)
        if (strcmp(arguments->given[i].option->name, name) == 0)
            return arguments->given[i].value;
    return NULL;
}

bool kg_arguments_number(const kg_arguments *arguments, const char *name, double lo, double hi,
                         double *out) {
    const char *text = kg_arguments_get(arguments, name);
    if (!text)
        return true;
    char *end;
    double x = strtod(text, &end);
    if (end == text || *end != '\0' || !(x >= lo && x <= hi))
        return kg_command_misuse(arguments->command,
                                 "--%s wants a number from %g to %g, not \"%s\"", name, lo, hi,
                                 text) == KG_EXIT_DONE;
    *out = x;
    return true;
}
