# creepcontact on any system with a container engine (docs/docker.md). Stage 1 builds the Debian package, stage 2 installs it.
FROM debian:12 AS build
WORKDIR /source
COPY . .
RUN apt-get update && bash scripts/package

FROM debian:12-slim
# PICTURES=1 adds still pictures of fields (VTK, a virtual display): half a gigabyte.
ARG PICTURES=0
COPY --from=build /source/build/package/*.deb /tmp/
RUN apt-get update \
    && apt-get install --yes --no-install-recommends /tmp/creepcontact_*.deb gnuplot-nox fonts-dejavu-core \
    && if [ "$PICTURES" = 1 ]; then apt-get install --yes --no-install-recommends python3-vtk9 xvfb xauth libgl1-mesa-dri; fi \
    && rm -rf /tmp/*.deb /var/lib/apt/lists/* \
    && useradd --create-home engineer
USER engineer
WORKDIR /work
ENTRYPOINT ["creepcontact"]
CMD ["--help"]
