/* A box of six planes that trim each other, its lid trimmed too or lying over the walls. */
#ifndef KG_TESTS_GUIDE_MODEL_H
#define KG_TESTS_GUIDE_MODEL_H

#include "katagami/document.h"
#include "tests/check.h"

static inline kg_document *solved_document(const char *json) {
    kg_model *model;
    kg_document *document;
    kg_error error;
    if (kg_model_read_memory(json, strlen(json), "test", &model, &error))
        fail_msg("%s", error.message);
    assert_int_equal(kg_document_from_model(model, NULL, &document, NULL), KG_OK);
    assert_int_equal(kg_document_solve(document, KG_NET_CHORD, NULL), KG_OK);
    if (kg_document_check(document, &error))
        fail_msg("%s", error.message);
    return document;
}

/* Planes through x = ±45, y = ±30, z = ±25, fronts outward. */
static inline kg_document *box_document(bool trimmed_lid) {
    static const char walls[] =
        "{\"id\":1,\"name\":\"底\",\"points\":[[-70,0,-25],[-20,0,-25],[20,0,-25],[70,0,-25]],"
        "\"extent\":[-70,70],\"ruling\":[0,1,0],\"flip\":true,"
        "\"trims\":[{\"by\":[3,4,5,6],\"inside\":true}]},"
        "{\"id\":3,\"name\":\"left\",\"points\":[[-45,-70,0],[-45,-20,0],[-45,20,0],[-45,70,0]],"
        "\"extent\":[-70,70],\"ruling\":[0,0,1],\"flip\":true,"
        "\"trims\":[{\"by\":[1,2,5,6],\"inside\":true}]},"
        "{\"id\":4,\"name\":\"right\",\"points\":[[45,-70,0],[45,-20,0],[45,20,0],[45,70,0]],"
        "\"extent\":[-70,70],\"ruling\":[0,0,1],"
        "\"trims\":[{\"by\":[1,2,5,6],\"inside\":true}]},"
        "{\"id\":5,\"name\":\"front\",\"points\":[[-70,-30,0],[-20,-30,0],[20,-30,0],[70,-30,0]],"
        "\"extent\":[-70,70],\"ruling\":[0,0,1],"
        "\"trims\":[{\"by\":[1,2,3,4],\"inside\":true}]},"
        "{\"id\":6,\"name\":\"back\",\"points\":[[-70,30,0],[-20,30,0],[20,30,0],[70,30,0]],"
        "\"extent\":[-70,70],\"ruling\":[0,0,1],\"flip\":true,"
        "\"trims\":[{\"by\":[1,2,3,4],\"inside\":true}]}";
    char json[4096];
    snprintf(json, sizeof json,
             "{\"katagami\":1,\"kind\":\"patches\",\"title\":\"box 箱\",\"patches\":[%s,"
             "{\"id\":2,\"name\":\"lid\",\"points\":[[-55,0,25],[-20,0,25],[20,0,25],[55,0,25]],"
             "\"extent\":[-40,40],\"ruling\":[0,1,0]%s}]}",
             walls, trimmed_lid ? ",\"trims\":[{\"by\":[3,4,5,6],\"inside\":true}]" : "");
    return solved_document(json);
}

#endif
