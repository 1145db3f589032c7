#include "viewer/view/scene_overlays.h"

#include <algorithm>

#include "viewer/overlay/bvh_overlay.h"
#include "viewer/overlay/debug_rays_overlay.h"
#include "viewer/overlay/lab_overlay.h"
#include "viewer/overlay/light_overlay.h"
#include "viewer/overlay/line_selection.h"
#include "viewer/overlay/surface_overlay.h"
#include "viewer/overlay/traversal_overlay.h"

namespace rayscope::viewer {

namespace {

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

/// The same view with fewer pixels.
ViewFrame shrunk(ViewFrame frame, int divisor) {
    frame.width = std::max(1, frame.width / divisor);
    frame.height = std::max(1, frame.height / divisor);
    return frame;
}

}  // namespace

SceneOverlays::Inputs SceneOverlays::inputsOf(const Workspace& workspace) {
    return {workspace.rays.version(),
            workspace.bvh.version(),
            workspace.rays.filter,
            workspace.rays.traversal,
            workspace.rays.surface,
            workspace.bvh.shown,
            workspace.lab.version(),
            workspace.lab.shownMethod,
            workspace.lab.overlay && workspace.lab.scene() == workspace.edit.scene.get()};
}

/// Surface and lens overlays of the selected sample.
void SceneOverlays::addSurfaces(const DebugRays::PixelRecording& recording, const DebugRays& rays,
                                float sceneSize) {
    const RayTree& tree = recording.tree();
    const SurfaceOverlayOptions& choice = rays.surface;
    for (int i = 0; i < static_cast<int>(tree.nodes.size()); ++i) {
        const RayNode& node = tree.nodes[static_cast<std::size_t>(i)];
        if (!isShown(tree, {i, -1}, rays.filter)) continue;
        if (rays.filter.vertexNormals)
            if (const auto normals = probe::vertexNormalsOf(*recording.world, node, tree.time))
                append(lines_, vertexNormalLines(*normals, sceneSize / 20.0f));
        if (choice.environment && node.hit)
            if (const auto point = probe::environmentOf(*recording.world, node))
                append(lines_, environmentLines(*point, node.position, sceneSize));
    }
    if (choice.glossySquare)
        for (const int i : probe::glossySurfaces(tree))
            if (const auto square = probe::glossySquareOf(*recording.world, tree, i))
                append(lines_, glossySquareLines(*square));
    if (choice.lens)
        if (const auto lens = probe::lensOf(*recording.world)) append(lines_, lensLines(*lens));
}

void SceneOverlays::addRays(const DebugRays::PixelRecording& recording, const DebugRays& rays,
                            float sceneSize) {
    const DebugRayFilter& filter = rays.filter;
    const RayWeights weights(recording.trees, filter);
    for (std::size_t i = 0; i < recording.trees.size(); ++i) {
        if (i == recording.chosen) continue;
        // Indices of selected and hidden rays belong to the selected sample.
        DebugRayFilter others = filter;
        others.selected = {};
        others.hidden.clear();
        append(lines_, debugRayLines(recording.trees[i], others, sceneSize, weights));
    }
    append(lines_, debugRayLines(recording.tree(), filter, sceneSize, weights));
    addSurfaces(recording, rays, sceneSize);
    for (const probe::TraversalLog& log : rays.traversals()) {
        append(boxes_, traversalBoxes(log, rays.traversal));
        append(lines_, traversalLines(log, recording.world->motionGroups[log.motionGroup].geometry->input,
                                      rays.traversal, sceneSize));
    }
}

void SceneOverlays::rebuild(const Workspace& workspace, float sceneSize) {
    lines_.clear();
    boxes_.clear();
    if (const DebugRays::PixelRecording* recording = workspace.rays.recording())
        addRays(*recording, workspace.rays, sceneSize);
    if (const LabResult* lab = workspace.lab.result(); lab && inputsOf(workspace).lab)
        append(lines_, labFailureLines(*lab, workspace.lab.shownMethod));
    if (const BvhInspector::InspectedTree* inspected = workspace.bvh.inspected()) {
        const BvhOverlayOptions& choice = workspace.bvh.shown;
        const BvhInspector::InspectedTree* referenceTree = workspace.bvh.referenceTree();
        const std::optional<IndexedTree> indexedReference =
            referenceTree ? std::optional<IndexedTree>(referenceTree->indexed()) : std::nullopt;
        append(boxes_,
               levelBoxes(inspected->indexed(), indexedReference ? &*indexedReference : nullptr, choice));
        append(boxes_, nodeBoxes(inspected->tree(), choice.node));
        append(boxes_, leafBoxes(inspected->indexed(), choice));
        append(lines_, leafLines(inspected->indexed(), inspected->geometry->input, choice));
    }
}

SceneOverlays::Drawing SceneOverlays::draw(const Workspace& workspace, const ViewFrame& frame,
                                           float sceneSize, const DrawingBudget& budget) {
    const Inputs inputs = inputsOf(workspace);
    if (inputs != built_ || sceneSize != builtSize_) {
        rebuild(workspace, sceneSize);
        built_ = inputs;
        builtSize_ = sceneSize;
    }
    BoxSelection boxes = selectBoxes(boxes_, shrunk(frame, budget.divisor), budget.boxes);
    const OverlayLines rays = selectLines(lines_, frame, budget.linePixels);
    Drawing drawing;
    drawing.counts.boxes = boxes.large;
    drawing.counts.boxesDrawn = boxes.whole.size();
    drawing.counts.lines = lines_.size();
    drawing.counts.linesDrawn = rays.size();
    for (const OverlayBox& box : boxes.whole)
        if (box.width >= kBoldWidth)
            appendBox(drawing.boldLines, box.lower, box.upper, box.color, box.style, box.width);
    std::erase_if(boxes.whole, [](const OverlayBox& box) { return box.width >= kBoldWidth; });
    drawing.boxes = std::move(boxes.whole);
    append(boxes.strokes, rays);
    for (const OverlayLine& line : boxes.strokes)
        (isBold(line) ? drawing.boldLines : drawing.lines).push_back(line);
    append(drawing.boldLines, lightLines(workspace.edit.scene->lights, workspace.view.selectedLight, frame,
                                         static_cast<double>(workspace.view.scale)));
    constexpr std::size_t kEdges = 12;
    drawing.painted = drawing.lines.size() + kEdges * drawing.boxes.size() > budget.maxWideLines;
    return drawing;
}

}  // namespace rayscope::viewer
