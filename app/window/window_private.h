/* SPDX-License-Identifier: MIT */
/* The inside of a window, for the files that make it up. */
#ifndef LUXEL_APP_WINDOW_PRIVATE_H
#define LUXEL_APP_WINDOW_PRIVATE_H

#include "../files/recovery.h"
#include "../form/points.h"
#include "../form/repair.h"
#include "../form/sources.h"
#include "../numbers/numbers.h"
#include "../numbers/why.h"
#include "../picture/dial.h"
#include "../picture/display_form.h"
#include "../picture/view.h"
#include "../space/stage.h"
#include "export.h"
#include "window.h"

enum { APP_STATUS_KINDS = 3 };

struct _AppWindow {
    GtkApplicationWindow parent;
    AppDocument *document;
    AppRecovery *recovery;
    luxel_parameters *parameters; /* in the user's language */
    AppPainter *painter;
    AppMeter *meter;
    AppPointer *pointer;
    AppSurvey *survey;

    AppPicture *picture; /* the last good one; NULL: none of this scene yet */
    guint64 version; /* of the document, the light that alone is seen and the quantity: what a picture is asked of */
    guint64 surveyed; /* the version that grids and observers were asked of last */
    guint64 first;    /* the first one since another scene was opened */
    guint64 origin, serial; /* of the document in that version */
    gssize asked_solo;
    luxel_quantity asked_quantity;
    AppVersion reading; /* that the line at the edge is of */
    double reading_mm[2];
    guint late;         /* of enum Behind: what has not followed for a while */
    gboolean is_direct; /* the light that surfaces reflect is not wanted: it was stopped */
    gboolean is_stale;  /* the document was refused: what is shown is of a scene of before */
    AppRepair *repair;  /* that is offered then; NULL: none */
    GHashTable *report; /* what a report says of who hands it in, by the keys of the settings */
    AppShot *pinned;
    AppSide side;
    gssize solo;
    luxel_quantity quantity;
    double section_mm[2];
    double pointer_mm[2];
    gboolean pointer_inside;
    gboolean is_on_surface; /* what was read there last */
    GPtrArray *unsaved;     /* AppUnsaved's that are still to be offered */
    gboolean is_discarded;  /* the first of them, which can be taken back until the bar is closed */
    guint progress_timer, pulse_timer, say_timer, late_timer, outside_timer;
    GFileMonitor *monitor;       /* of the document's file, */
    GFile *watched;              /* which is this one; NULL: it has none */
    int left_width, right_width; /* of the panes, as a hand left them */
    gboolean is_right_shown;     /* beside the picture, where there is room for it */
    gboolean is_narrow;          /* there is none: it is a drawer, */
    gboolean is_drawer_open;     /* which is asked for */
    gboolean is_placed;          /* they are where they belong */
    gboolean is_pressed;         /* a button of the mouse, in this window */
    gboolean is_hinting;         /* no mark was dragged yet */
    GSettings *settings;         /* NULL: none */
    const char *false_palette;   /* of false colour */

    /* of the template */
    AppView *view;
    GtkWidget *pages, *left_pane, *right_pane, *left_scroll, *left_box, *right_box, *compare_box, *compare_label, *bar;
    GtkWidget *cameras;      /* picture and space, of which one is seen, */
    GtkWidget *view_overlay; /* and what lies over them */
    GtkWidget *unsaved_bar, *unsaved_label, *discard_button, *fault_bar, *fault_label, *outside_bar, *outside_label;
    GtkWidget *direct_label; /* what the picture is, before reflected light has come */
    GtkWidget *progress_label, *stop_button;
    GtkWidget *stale_bar, *stale_label, *repair_button, *repair_label;
    GtkWidget *status_label, *message_label, *zoom_label, *progress;
    PangoTabArray *status_tabs[APP_STATUS_KINDS]; /* of its columns: all, without the normal, and of colours */
    int status_widths[APP_STATUS_KINDS];          /* of all columns with the sources' shares, dots */
    GMenu *builtin_menu, *recent_menu, *export_menu;
    /* made by hand */
    GtkWidget *screen_form, *surface_list, *surface_form, *material_form, *picture_form;
    GtkWidget *sources, *points, *display_form, *numbers, *stage, *space_view, *why;
    GtkWidget *search, *found, *found_list; /* of rows of the form */
    GtkWidget *gallery;                     /* NULL: it was not asked for yet */
};

/* Whether the window is still there for what was begun in it: a file, a paste. */
gboolean app_window_is_open(AppWindow *self);
/* Files of these patterns can be shown alone. */
void app_chooser_add_filter(GtkFileChooser *chooser, const char *name, const char *const *patterns);
/* Asks for a picture of the document as it is, and for the numbers beside the last one. */
void app_window_ask_picture(AppWindow *self);
void app_window_ask_numbers(AppWindow *self);
void app_window_ask_pointer(AppWindow *self);

/* The chosen sources are marked on the picture and in space. */
void app_window_show_chosen(AppWindow *self);

/* window_show.c: what comes is shown; of the painter, the meter and the pointer. */
void app_window_show_picture(AppPicture *picture, gpointer owner);
void app_window_show_numbers(AppMeasures *measures, gpointer owner);
void app_window_show_reading(const AppReading *reading, gpointer owner);
/* The status line's words where the pointer is not in the picture: a bound that was missed, or nothing. */
void app_window_rest(AppWindow *self);
void app_window_set_columns(AppWindow *self);
/* Says something at the edge of the window. */
void app_window_say(AppWindow *self, const char *text);
/* Says something for some seconds only. */
void app_window_mention(AppWindow *self, const char *text);
/* Shows what went wrong with a file or a paste; NULL: nothing. */
void app_window_show_fault(AppWindow *self, const char *text);
/* A text that may be longer than its line, where its tooltip has all of it. */
void app_window_set_message(GtkWidget *label, const char *text);
/* Shows or hides a bar; where the keyboard was in one that goes, the picture has it, and no form is scrolled to. */
void app_window_reveal_bar(AppWindow *self, GtkWidget *bar, gboolean revealed);
/* The picture that the numbers are of, and the one that is taken off it; NULL: none. */
AppShot *app_window_shot(const AppWindow *self);
AppShot *app_window_minus(const AppWindow *self);

/* window_version.c: which version of the scene is shown, and what belongs to it; all parts are told there. */
AppVersion app_window_version(const AppWindow *self);
/* Something has come, or the document has changed: what is not of the version that is shown is dimmed. */
void app_window_judge(AppWindow *self);
/* Another scene was opened: nothing is left of the one before. */
void app_window_forget(AppWindow *self);
/* The pointer is elsewhere, and what is there has not come for a while. */
void app_window_await_reading(AppWindow *self);

/* window_stale.c: a document that cannot be computed; `faults` NULL: it can. */
void app_window_set_stale(AppWindow *self, const luxel_diagnostics *faults);
void app_window_make_repair(AppWindow *self);
/* Where nothing is seen, as a plate shows the observer its back, says so and offers to turn it. */
void app_window_offer_turn(AppWindow *self, const AppPicture *picture);

/* window_space.c: the scene in space, in the place of the picture. */
void app_window_add_space(AppWindow *self);
/* What the hand does in space, plan and elevation is told to the others. */
void app_window_connect_spaces(AppWindow *self);
/* Grids and observers, where the scene has some, are measured, and shown on their page, in plan and in space. */
void app_window_ask_survey(AppWindow *self);
void app_window_show_survey(AppGrids *grids, AppEyes *eyes, guint64 serial, gpointer owner);
/* The sights of plan and elevation, and of space, of which there are so many. */
enum { APP_SIGHTS = 2 };
AppSight *app_window_sight(AppWindow *self, int i);
/* Both show the vectors of the formula at the place that was read; NULL: none. */
void app_window_show_vectors(AppWindow *self, const AppReading *reading);
/* A lamp that the pointer is on, or -1, is lit up wherever it is shown, but for the picture. */
void app_window_hover_light(AppWindow *self, gssize light);
gboolean app_window_is_in_space(AppWindow *self);
/* That of the two that is seen. */
GtkWidget *app_window_camera(AppWindow *self);

/* window_panes.c: the widths of the panes, in whatever window they stand. */
void app_window_watch_panes(AppWindow *self);
/* The numbers at the side come or go. */
void app_window_show_right(AppWindow *self, gboolean shown);

/* window_sections.c: the sections of the form at the left, which of them are open, and the search for a key in them. */
/* One more, under the name that the settings have of it, with up to three parts (NULL: none). */
void app_window_add_section(AppWindow *self, const char *name, const char *title, GtkWidget *first, GtkWidget *second,
                            GtkWidget *third);
void app_window_open_sections(AppWindow *self);
void app_window_add_search(AppWindow *self);

/* window_focus.c: the keyboard goes from pane to pane. */
void app_window_add_focus_actions(AppWindow *self);
/* A dialog has gone: the keyboard is in the window again, on the picture where it was nowhere. */
void app_window_take_keyboard(AppWindow *self);

/* window_room.c: a new room with luminaires. */
void app_window_add_room_action(AppWindow *self);

/* window_report.c: who hands a report in is asked before its file is. */
void app_window_ask_report(AppWindow *self, void (*done)(AppWindow *self));
void app_window_init_report(AppWindow *self);
void app_window_load_report(AppWindow *self, AppReport *report);

/* Where the card “Why?” is shown, it is kept at a place of the screen, and with a point (-1: none) where that is. */
void app_window_pin_why(AppWindow *self, const double place_mm[2], gssize point);
/* The card is opened, at a point of the scene, or where the pointer is. */
void app_window_ask_why(AppWindow *self, gssize point);

/* window_actions.c */
void app_window_add_actions(AppWindow *self);
void app_window_update_actions(AppWindow *self);
/* window_chosen.c: a mesh or a luminaire becomes a part of the scene; FALSE: the file is neither. */
gboolean app_window_take_file(AppWindow *self, const char *path);
void app_window_add_chosen_actions(AppWindow *self);
/* window_surfaces.c */
GtkWidget *app_window_new_surface_bar(AppWindow *self);
void app_window_add_surface_actions(AppWindow *self);
/* window_begin.c: what helps to begin: pictures of scenes, and a hint until a mark was dragged. */
void app_window_add_begin_actions(AppWindow *self);
void app_window_begin_hint(AppWindow *self);
void app_window_update_hint(AppWindow *self);
gboolean app_window_gallery_is_open(AppWindow *self);
/* window_outside.c: the file is watched, as other programs may change it. */
void app_window_add_outside_actions(AppWindow *self);
void app_window_watch_file(AppWindow *self);
void app_window_end_watch(AppWindow *self);
/* Whether nothing is lost by saving to a path; else it is asked. */
gboolean app_window_may_overwrite(AppWindow *self, const char *path);
/* window_files.c */
void app_window_add_file_actions(AppWindow *self);
void app_window_fill_menus(AppWindow *self);

#endif
