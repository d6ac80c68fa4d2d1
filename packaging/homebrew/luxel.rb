# SPDX-License-Identifier: MIT
# The formula for Homebrew, which has not been tried.
class Luxel < Formula
  desc "How light sources brighten a surface: exact values with a bound of their error"
  homepage "https://example.org/luxel"
  url "https://example.org/luxel/luxel-0.1.0-source.tar.gz"
  sha256 "FILL-IN"
  license all_of: ["MIT", "Apache-2.0"]

  depends_on "gettext" => :build
  depends_on "meson" => :build
  depends_on "ninja" => :build
  depends_on "pkg-config" => :build
  depends_on "cairo"
  depends_on "libfyaml"
  depends_on "libpng"
  depends_on "openexr"
  depends_on "pango"

  def install
    system "meson", "setup", "build", *std_meson_args,
           "-Dtests=false", "-Dpython=disabled", "-Dapp=disabled", "-Dhdf5=disabled", "-Dmpi=disabled"
    system "meson", "compile", "-C", "build"
    system "meson", "install", "-C", "build"
  end

  test do
    assert_match "2.72759065255", shell_output("#{bin}/luxel probe report -p 0,0")
  end
end
