// Traces rays with Embree 3, one at a time on one thread, for glint.bench.EmbreeKernel: reads the triangles of the file `mesh`,
// then, from standard input, lines "closest FILE" or "any FILE", and answers each with "CPU-seconds hits".
#include <embree3/rtcore.h>
#include <arpa/inet.h>
#include <time.h>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <vector>

static std::vector<float> read(const std::string& name) {
    std::ifstream in(name, std::ios::binary | std::ios::ate);
    std::vector<uint32_t> words(in.tellg() / 4);
    in.seekg(0);
    in.read(reinterpret_cast<char*>(words.data()), 4 * words.size());
    std::vector<float> out(words.size());
    for (size_t i = 0; i < words.size(); i++) {
        uint32_t host = ntohl(words[i]);
        memcpy(&out[i], &host, 4);
    }
    return out;
}

static double now() {
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}

int main() {
    RTCDevice device = rtcNewDevice(nullptr);
    RTCScene scene = rtcNewScene(device);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    std::vector<float> mesh = read("mesh");
    size_t points = mesh.size() / 3;
    void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, points);
    memcpy(vertices, mesh.data(), 4 * mesh.size());
    auto* corners = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, points / 3));
    for (size_t i = 0; i < points; i++) corners[i] = i;
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcCommitScene(scene);

    std::map<std::string, std::vector<float>> loaded;
    std::string how, name;
    while (std::cin >> how >> name) {
        if (!loaded.count(name)) loaded[name] = read(name);
        const std::vector<float>& rays = loaded[name];
        bool any = how == "any";
        long hits = 0;
        double began = now();
        for (size_t i = 0; i < rays.size(); i += 7) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            RTCRayHit r;
            r.ray.org_x = rays[i];
            r.ray.org_y = rays[i + 1];
            r.ray.org_z = rays[i + 2];
            r.ray.dir_x = rays[i + 3];
            r.ray.dir_y = rays[i + 4];
            r.ray.dir_z = rays[i + 5];
            r.ray.tnear = 1e-5f;
            r.ray.tfar = rays[i + 6];
            r.ray.time = 0;
            r.ray.mask = -1;
            r.ray.flags = 0;
            r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            if (any) {
                rtcOccluded1(scene, &context, &r.ray);
                hits += r.ray.tfar < 0;
            } else {
                rtcIntersect1(scene, &context, &r);
                hits += r.hit.geomID != RTC_INVALID_GEOMETRY_ID;
            }
        }
        std::cout << now() - began << " " << hits << std::endl;
    }
}
