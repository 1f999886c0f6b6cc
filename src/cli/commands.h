/* The commands, one file each. */
#ifndef KG_CLI_COMMANDS_H
#define KG_CLI_COMMANDS_H

int kg_command_apply(int argc, char **argv);
int kg_command_check(int argc, char **argv);
int kg_command_edit(int argc, char **argv);
int kg_command_export(int argc, char **argv);
int kg_command_info(int argc, char **argv);
int kg_command_net(int argc, char **argv);
int kg_command_new(int argc, char **argv);
int kg_command_oa(int argc, char **argv);
int kg_command_render(int argc, char **argv);

#endif
