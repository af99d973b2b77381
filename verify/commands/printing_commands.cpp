// requad-verify --list, --proofs, --errata and --sentences: what is known without a campaign.

#include <iostream>

#include "mesh/program/layout.hpp"
#include "verify/claims/claims.hpp"
#include "verify/commands/commands.hpp"
#include "verify/errata.hpp"
#include "verify/report/report.hpp"
#include "verify/sentences.hpp"

namespace requad::verify {

namespace {

using program::Options;

int print_claims(const Options& options) {
  std::string text;
  for (const Claim& c : claims()) {
    text += c.id + "  " + c.statement + " [" + c.where + "]\n";
    text += "     compares: " + c.compares + "\n     fails if: " + c.fails_if + "\n";
    text += "     checked on: " + range_text({}, c.families) + "\n     for all sizes: " +
            (theory::proof_of(c.id) ? "proved from the side-length law (--proofs --claim " + c.id + ")" : "no proof") +
            "\n";
  }
  program::finish(options, claims_json().dump(), text);
  return program::kDone;
}

int print_errata(const Options& options) {
  program::finish(options, errata_json().dump(), errata_text());
  return program::kDone;
}

int print_sentences(const Options& options) {
  program::finish(options, sentences_json().dump(), sentences_text());
  return program::kDone;
}

// Exit code: kDone if all proofs go through, kUndecided if there is none.
int print_proofs(const Options& options) {
  int code = program::kUndecided;
  std::string text;
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const Claim* claim : named_claims(options)) {
    const auto proof = theory::proof_of(claim->id);
    if (!proof) continue;
    text += (code == program::kUndecided ? "" : "\n") + proof_text(*proof);
    json[claim->id] = proof_json(proof);
    if (code == program::kUndecided || !proof->proved())
      code = proof->proved() ? program::kDone : program::kCheckFailed;
  }
  if (code == program::kUndecided) text = "no proof for all sizes: instances only\n";
  program::finish(options, nlohmann::ordered_json{{"proofs", json}}.dump(), text);
  return code;
}

}  // namespace

program::Command list_command() {
  return {
      .name = "--list",
      .usage = {""},
      .summary =
          "prints the claims, with what each check compares, what makes it fail, the default range, and whether there "
          "is a proof for all sizes, and checks nothing",
      .examples = {"requad-verify --list --json claims.json"},
      .options = {},
      .run = print_claims,
  };
}

program::Command errata_command() {
  return {
      .name = "--errata",
      .usage = {""},
      .summary = "prints the slips in the paper's text, each with what is true and the smallest region that shows it",
      .examples = {"requad-verify --errata --json errata.json"},
      .options = {},
      .run = print_errata,
  };
}

program::Command sentences_command() {
  return {
      .name = "--sentences",
      .usage = {""},
      .summary = "prints the sentences of the paper that no check can decide, with the reasons, and checks nothing",
      .examples = {"requad-verify --sentences --json -"},
      .options = {},
      .run = print_sentences,
  };
}

program::Command proofs_command() {
  return {
      .name = "--proofs",
      .usage = {"[--claim ID]..."},
      .summary =
          "prints the proofs for all sizes, step by step, of the claims that linear algebra decides, and checks "
          "no region",
      .examples = {"requad-verify --proofs --claim T2"},
      .options = {program::list("claim", "ID", "print the proof of this claim only; may be repeated (default: all)")},
      .run = print_proofs,
  };
}

}  // namespace requad::verify
