<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Wording</name>
    <message>
        <source>exact set</source>
        <translation>精确</translation>
    </message>
    <message>
        <source>lossless</source>
        <translation>无损</translation>
    </message>
    <message>
        <source>lossy</source>
        <translation>有损</translation>
    </message>
    <message>
        <source>draws what is visible and nothing in vain</source>
        <translation>只绘制可见的内容，不多不少</translation>
    </message>
    <message>
        <source>loses no visible pixel, may draw in vain</source>
        <translation>不丢失可见像素，可能白画</translation>
    </message>
    <message>
        <source>may lose pixels: how many is measured</source>
        <translation>可能丢失像素：丢失多少会被测量</translation>
    </message>
    <message>
        <source>front faces only</source>
        <translation>仅正面</translation>
    </message>
    <message>
        <source>both sides</source>
        <translation>双面</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>large scene: figures on request</source>
        <translation>大型场景：按需测量</translation>
    </message>
    <message>
        <source>no figures</source>
        <translation>无数据</translation>
    </message>
    <message>
        <source>%1 · %2 % · %3 missed</source>
        <extracomment>Line 2 of a view&apos;s header: speed against `backface`, share of the triangles submitted, missed pixels.</extracomment>
        <translation>%1 · %2 % · 丢失 %3</translation>
    </message>
    <message>
        <source>Speed: %1 fps = 1 / (cull + draw), %2 a frame, of which %3 culling</source>
        <translation>速度：%1 fps = 1 /（剔除 + 绘制），每帧 %2，其中剔除 %3</translation>
    </message>
    <message>
        <source>Submitted: %1 of %2 triangles, %3 of them visible</source>
        <translation>提交：%2 个三角形中的 %1 个，其中 %3 个可见</translation>
    </message>
    <message>
        <source>Missed: %1 of %2 covered pixels, largest hole %3</source>
        <translation>丢失：%2 个覆盖像素中的 %1 个，最大空洞 %3</translation>
    </message>
    <message>
        <source>Truth: item buffer of %1 × %2 pixels, %3</source>
        <translation>真实结果：%1 × %2 像素的项缓冲，%3</translation>
    </message>
    <message>
        <source>Software OpenGL: %1</source>
        <translation>软件 OpenGL：%1</translation>
    </message>
    <message>
        <source>OpenGL: %1</source>
        <translation>OpenGL：%1</translation>
    </message>
    <message>
        <source>Of the missed, beyond the raster&apos;s snapping to 1/256 pixel: %1</source>
        <translation>丢失像素中无法用光栅 1/256 像素对齐解释的：%1</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>Nothing in the file had to be repaired.</source>
        <translation>文件中没有需要修复的内容。</translation>
    </message>
    <message>
        <source>This view cannot be measured: %1</source>
        <translation>无法测量此视图：%1</translation>
    </message>
    <message>
        <source>No OpenGL context can be made on this display. Install a graphics driver or Mesa.</source>
        <translation>无法在此显示器上创建 OpenGL 上下文。请安装显卡驱动或 Mesa。</translation>
    </message>
    <message>
        <source>The OpenGL context cannot be used on this display. Update the graphics driver.</source>
        <translation>无法在此显示器上使用 OpenGL 上下文。请更新显卡驱动。</translation>
    </message>
    <message>
        <source>There is not enough memory to open %1. Choose a smaller model.</source>
        <translation>内存不足，无法打开 %1。请选择较小的模型。</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation>无法打开 %1：%2</translation>
    </message>
    <message>
        <source>Opening %1 was cancelled.</source>
        <translation>已取消打开 %1。</translation>
    </message>
    <message>
        <source>The scene cannot be given to OpenGL: %1</source>
        <translation>无法将场景交给 OpenGL：%1</translation>
    </message>
    <message>
        <source>The strategy %1 cannot be built for this scene: %2</source>
        <translation>无法为此场景准备策略 %1：%2</translation>
    </message>
    <message>
        <source>The Qt platform %1 has no OpenGL for windows. Unset QT_QPA_PLATFORM, or use cullbench, which needs no display.</source>
        <translation>Qt 平台 %1 没有用于窗口的 OpenGL。请取消设置 QT_QPA_PLATFORM，或使用不需要显示器的 cullbench。</translation>
    </message>
    <message>
        <source>There is no display: neither DISPLAY nor WAYLAND_DISPLAY is set. Start cullscope in a desktop session, or use cullbench, which needs no display.</source>
        <translation>没有显示器：DISPLAY 和 WAYLAND_DISPLAY 均未设置。请在桌面会话中启动 cullscope，或使用不需要显示器的 cullbench。</translation>
    </message>
    <message>
        <source>This display offers no OpenGL 4.5. Update the graphics driver, or use cullbench, which needs no display.</source>
        <translation>此显示器不提供 OpenGL 4.5。请更新显卡驱动，或使用不需要显示器的 cullbench。</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Choose another place or free some space.</source>
        <translation>无法写入 %1：%2。请选择其他位置或释放一些空间。</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>已停止。</translation>
    </message>
    <message>
        <source>There is no OpenGL context here: install a graphics driver with OpenGL 4.5, or Mesa.</source>
        <translation>这里没有 OpenGL 上下文：请安装支持 OpenGL 4.5 的显卡驱动或 Mesa。</translation>
    </message>
    <message>
        <source>OpenGL 4.5 is needed and this machine has %1 (%2): update the graphics driver, or use Mesa&apos;s software OpenGL with LIBGL_ALWAYS_SOFTWARE=1.</source>
        <translation>需要 OpenGL 4.5，而本机为 %1（%2）：请更新显卡驱动，或设置 LIBGL_ALWAYS_SOFTWARE=1 使用 Mesa 的软件 OpenGL。</translation>
    </message>
    <message>
        <source>No OpenGL 4.5 context without a display: EGL&apos;s surfaceless and device platforms were both tried. Install libegl1 with Mesa (libgl1-mesa-dri) or the GPU&apos;s driver.</source>
        <translation>无法在没有显示器的情况下创建 OpenGL 4.5 上下文：已尝试 EGL 的 surfaceless 和 device 平台。请安装 libegl1 以及 Mesa（libgl1-mesa-dri）或 GPU 驱动。</translation>
    </message>
    <message>
        <source>This OpenGL cannot make a picture of %1x%2 pixels: choose a smaller size.</source>
        <translation>此 OpenGL 无法创建 %1x%2 像素的图像：请选择较小的尺寸。</translation>
    </message>
    <message>
        <source>The graphics driver refuses a shader: %1</source>
        <translation>显卡驱动拒绝了着色器：%1</translation>
    </message>
    <message>
        <source>Client vertex arrays need OpenGL&apos;s compatibility profile, which this driver does not give: use buffer objects (vbo).</source>
        <translation>客户端顶点数组需要 OpenGL 兼容配置，而此驱动不提供：请使用缓冲对象（vbo）。</translation>
    </message>
    <message>
        <source>The graphics memory does not hold this scene (%1 bytes): use client vertex arrays or a smaller scene.</source>
        <translation>显存容纳不下此场景（%1 字节）：请使用客户端顶点数组或较小的场景。</translation>
    </message>
    <message>
        <source>measuring</source>
        <translation>正在测量</translation>
    </message>
    <message>
        <source>No strategy is named: give one with -s.</source>
        <translation>未指定策略：请用 -s 指定。</translation>
    </message>
    <message>
        <source>The camera path has no poses.</source>
        <translation>相机路径中没有位姿。</translation>
    </message>
    <message>
        <source>The scene has no triangles: there is nothing to measure.</source>
        <translation>场景中没有三角形：没有可测量的内容。</translation>
    </message>
    <message>
        <source>%1: pictures are written as .png, .jpg, .tif or .exr; choose one of these endings.</source>
        <translation>%1：图像以 .png、.jpg、.tif 或 .exr 写入；请选择其中一种扩展名。</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>无法写入 %1：%2</translation>
    </message>
    <message>
        <source>%1 is no picture that can be read: %2</source>
        <translation>%1 不是可读取的图像：%2</translation>
    </message>
    <message>
        <source>The scene has too many triangles for the ray reference.</source>
        <translation>场景的三角形过多，无法使用光线参考。</translation>
    </message>
    <message>
        <source>The scene has %1 triangles; the item buffer numbers at most 4294967294. Measure a part of it.</source>
        <translation>场景有 %1 个三角形；项缓冲最多可编号 4294967294 个。请只测量其中一部分。</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2. Check the path and the permissions.</source>
        <translation>无法打开 %1：%2。请检查路径和权限。</translation>
    </message>
    <message>
        <source>%1 is a folder. Name a mesh file inside it.</source>
        <translation>%1 是文件夹。请指定其中的网格文件。</translation>
    </message>
    <message>
        <source>%1 is empty. Fetch or export the file again.</source>
        <translation>%1 是空文件。请重新获取或导出。</translation>
    </message>
    <message>
        <source>%1 is not a regular file. Save the mesh in a file and name that.</source>
        <translation>%1 不是普通文件。请将网格保存到文件中再指定它。</translation>
    </message>
    <message>
        <source>%1 cannot be read after byte %2: %3. Copy the file again.</source>
        <translation>无法读取 %1 第 %2 字节之后的内容：%3。请重新复制该文件。</translation>
    </message>
    <message>
        <source>Reading the file</source>
        <translation>正在读取文件</translation>
    </message>
    <message>
        <source>%1, line %2 is longer than %3 MB. Check that the file is a mesh in a text format.</source>
        <translation>%1 第 %2 行超过 %3 MB。请确认该文件是文本格式的网格。</translation>
    </message>
    <message>
        <source>%1 is compressed with xz. Unpack it first: xz -dk &quot;%1&quot;.</source>
        <translation>%1 经 xz 压缩。请先解压：xz -dk &quot;%1&quot;。</translation>
    </message>
    <message>
        <source>%1 is compressed with gzip. Unpack it first: gzip -dk &quot;%1&quot;.</source>
        <translation>%1 经 gzip 压缩。请先解压：gzip -dk &quot;%1&quot;。</translation>
    </message>
    <message>
        <source>%1 is an archive or compressed. Unpack it first.</source>
        <translation>%1 是归档或压缩文件。请先解压。</translation>
    </message>
    <message>
        <source>%1 is a Git LFS pointer, not the mesh itself. Fetch the mesh with: git lfs pull.</source>
        <translation>%1 是 Git LFS 指针，而不是网格本身。请用 git lfs pull 获取网格。</translation>
    </message>
    <message>
        <source>%1 is UTF-16 text. Save it as UTF-8 or ASCII.</source>
        <translation>%1 是 UTF-16 文本。请另存为 UTF-8 或 ASCII。</translation>
    </message>
    <message>
        <source>%1 is none of the mesh formats that are read (%2). Export the mesh in one of them.</source>
        <translation>%1 不是可读取的网格格式（%2）。请将网格导出为其中一种。</translation>
    </message>
    <message>
        <source>Checking the mesh</source>
        <translation>正在检查网格</translation>
    </message>
    <message>
        <source>%1 needs more memory than this machine gives. Simplify the mesh or split the file.</source>
        <translation>%1 需要的内存超过本机可提供的。请简化网格或拆分文件。</translation>
    </message>
    <message>
        <source>Degenerate faces dropped (fewer than three different corners, or no area): %1.</source>
        <translation>丢弃的退化面（不同顶点少于三个或没有面积）：%1。</translation>
    </message>
    <message>
        <source>Duplicate faces dropped: %1.</source>
        <translation>丢弃的重复面：%1。</translation>
    </message>
    <message>
        <source>Non-manifold edges kept (with more than two triangles): %1.</source>
        <translation>保留的非流形边（多于两个三角形）：%1。</translation>
    </message>
    <message>
        <source>Vertices dropped whose coordinates are NaN, infinite or beyond 1e30, with the faces that use them: %1.</source>
        <translation>坐标为 NaN、无穷或超过 1e30 而连同所用面一起丢弃的顶点：%1。</translation>
    </message>
    <message>
        <source>Faces dropped that name a vertex which does not exist: %1.</source>
        <translation>因引用不存在的顶点而丢弃的面：%1。</translation>
    </message>
    <message>
        <source>Vertices dropped that no face uses: %1.</source>
        <translation>因没有面使用而丢弃的顶点：%1。</translation>
    </message>
    <message>
        <source>%1 needs about %2 MB of memory, more than the %3 MB allowed. Simplify the mesh, split the file, or allow more.</source>
        <translation>%1 约需 %2 MB 内存，超过允许的 %3 MB。请简化网格、拆分文件或提高上限。</translation>
    </message>
    <message>
        <source>%1 has more than 2,147,483,647 vertices in one object. Split the object.</source>
        <translation>%1 中有一个物体的顶点超过 2,147,483,647 个。请拆分该物体。</translation>
    </message>
    <message>
        <source>%1: the object &quot;%2&quot; is smaller than 1e-30. Scale it up.</source>
        <translation>%1：物体“%2”小于 1e-30。请将其放大。</translation>
    </message>
    <message>
        <source>%1 holds no faces. Export the mesh with its faces, not only points or lines.</source>
        <translation>%1 中没有面。请连同面一起导出网格，而不只是点或线。</translation>
    </message>
    <message>
        <source>%1 holds no usable face: all %2 are without area, out of range or not finite. Export the mesh again.</source>
        <translation>%1 中没有可用的面：全部 %2 个面没有面积、超出范围或不是有限值。请重新导出网格。</translation>
    </message>
    <message>
        <source>Normals made from the faces because some were missing or unusable: %1.</source>
        <translation>因缺失或不可用而由面生成的法线：%1。</translation>
    </message>
    <message>
        <source>Polygons with so many corners that they were cut as fans, which may cover too much: %1.</source>
        <translation>因顶点过多而按扇形切分的多边形（可能覆盖过多）：%1。</translation>
    </message>
    <message>
        <source>Duplicate faces and non-manifold edges were not looked for: the mesh has more than %1 faces.</source>
        <translation>网格的面超过 %1 个，未查找重复面和非流形边。</translation>
    </message>
    <message>
        <source>%1, line %2 goes on for more than %3 MB. Check that the file is a mesh in a text format.</source>
        <translation>%1 第 %2 行延续超过 %3 MB。请确认该文件是文本格式的网格。</translation>
    </message>
    <message>
        <source>%1, line %2: a vertex or normal has only %3 of 3 coordinates. Correct the line or export the file again.</source>
        <translation>%1 第 %2 行：顶点或法线的 3 个坐标只有 %3 个。请改正该行或重新导出文件。</translation>
    </message>
    <message>
        <source>%1, line %2: &quot;%3&quot; is not a number. Correct the line or export the file again.</source>
        <translation>%1 第 %2 行：“%3”不是数字。请改正该行或重新导出文件。</translation>
    </message>
    <message>
        <source>%1, line %2: &quot;%3&quot; is not a corner of a face. Correct the line or export the file again.</source>
        <translation>%1 第 %2 行：“%3”不是面的顶点。请改正该行或重新导出文件。</translation>
    </message>
    <message>
        <source>%1, line %2: the PLY header has no end_header. Fetch or export the file again.</source>
        <translation>%1 第 %2 行：PLY 文件头没有 end_header。请重新获取或导出文件。</translation>
    </message>
    <message>
        <source>%1, line %2: &quot;%3&quot; cannot be understood in a PLY header. Correct the line or export the file again.</source>
        <translation>%1 第 %2 行：无法理解 PLY 文件头中的“%3”。请改正该行或重新导出文件。</translation>
    </message>
    <message>
        <source>%1, line %2 promises %3 of &quot;%4&quot;, but only %5 bytes follow the header. The file was cut off or changed: fetch it again.</source>
        <translation>%1 第 %2 行声明有 %3 个“%4”，但文件头之后只有 %5 字节。文件被截断或改动：请重新获取。</translation>
    </message>
    <message>
        <source>%1, line %2 promises %3 of &quot;%4&quot;, which have no properties. Export the file again.</source>
        <translation>%1 第 %2 行声明有 %3 个“%4”，但它们没有属性。请重新导出文件。</translation>
    </message>
    <message>
        <source>Lines passed over because their keyword is unknown: %1, first line %2.</source>
        <translation>因关键字未知而跳过的行：%1，首见于第 %2 行。</translation>
    </message>
    <message>
        <source>%1 promises %2 vertices and %3 faces, but only %4 bytes follow. The file was cut off or changed: fetch it again.</source>
        <translation>%1 声明有 %2 个顶点和 %3 个面，但后面只有 %4 字节。文件被截断或改动：请重新获取。</translation>
    </message>
    <message>
        <source>%1 is an OFF file of another number of dimensions than three. Export a plain OFF file.</source>
        <translation>%1 是维数不为三的 OFF 文件。请导出普通的 OFF 文件。</translation>
    </message>
    <message>
        <source>%1 ends at byte %2, before everything that it promises. The file was cut off: fetch it again.</source>
        <translation>%1 在第 %2 字节处结束，内容不完整。文件被截断：请重新获取。</translation>
    </message>
    <message>
        <source>%1, byte %2 promises %3 values, but %4 bytes are left. The file was cut off or changed: fetch it again.</source>
        <translation>%1 第 %2 字节声明有 %3 个值，但只剩 %4 字节。文件被截断或改动：请重新获取。</translation>
    </message>
    <message>
        <source>%1, byte %2 cannot stand here in an OM file. The file was changed: fetch or export it again.</source>
        <translation>%1 第 %2 字节不应出现在 OM 文件的此处。文件被改动：请重新获取或导出。</translation>
    </message>
    <message>
        <source>%1 is no OM file: it does not begin with OMT, OMQ or OMP. Export the mesh again.</source>
        <translation>%1 不是 OM 文件：它不以 OMT、OMQ 或 OMP 开头。请重新导出网格。</translation>
    </message>
    <message>
        <source>%1 promises %2 vertices, %3 faces and %4 edges, but only %5 bytes follow. The file was cut off or changed: fetch it again.</source>
        <translation>%1 声明有 %2 个顶点、%3 个面和 %4 条边，但后面只有 %5 字节。文件被截断或改动：请重新获取。</translation>
    </message>
    <message>
        <source>%1: the edges of face %2 do not close up. The file was changed: fetch or export it again.</source>
        <translation>%1：面 %2 的边没有闭合。文件被改动：请重新获取或导出。</translation>
    </message>
    <message>
        <source>%1, line %2: the vertices have no x, y and z. Export the file again.</source>
        <translation>%1 第 %2 行：顶点没有 x、y 和 z。请重新导出文件。</translation>
    </message>
    <message>
        <source>%1 ends at byte %2, within number %3 of the %4 of &quot;%5&quot; that it promises. The file was cut off: fetch it again.</source>
        <translation>%1 在第 %2 字节处结束，位于所声明的 %4 个“%5”中的第 %3 个之内。文件被截断：请重新获取。</translation>
    </message>
    <message>
        <source>%1, byte %2: number %3 of &quot;%4&quot; promises a list of %5, but %6 bytes are left. The file was cut off or changed: fetch it again.</source>
        <translation>%1 第 %2 字节：第 %3 个“%4”声明了长度为 %5 的列表，但只剩 %6 字节。文件被截断或改动：请重新获取。</translation>
    </message>
    <message>
        <source>%1, line %2: a list cannot have %3 values. Correct the line or export the file again.</source>
        <translation>%1 第 %2 行：列表不能有 %3 个值。请改正该行或重新导出文件。</translation>
    </message>
    <message>
        <source>%1, line %2: the faces have no list of whole vertex numbers (vertex_indices). Export the file again.</source>
        <translation>%1 第 %2 行：面没有整数顶点编号列表（vertex_indices）。请重新导出文件。</translation>
    </message>
    <message>
        <source>Bytes after the end of the mesh that were passed over: %1.</source>
        <translation>网格结束之后被跳过的字节：%1。</translation>
    </message>
    <message>
        <source>%1 ends at byte %2, within the header of a binary STL. The file was cut off: fetch it again.</source>
        <translation>%1 在第 %2 字节处结束，位于二进制 STL 文件头之内。文件被截断：请重新获取。</translation>
    </message>
    <message>
        <source>%1, byte 80 promises %2 triangles, but the file has room for %3. The file is no STL or was cut off: fetch it again.</source>
        <translation>%1 第 80 字节声明有 %2 个三角形，但文件只容得下 %3 个。该文件不是 STL 或被截断：请重新获取。</translation>
    </message>
    <message>
        <source>%1, line %2: &quot;%3&quot; cannot stand here in an STL file. Correct the line or export the file again.</source>
        <translation>%1 第 %2 行：“%3”不应出现在 STL 文件的此处。请改正该行或重新导出文件。</translation>
    </message>
    <message>
        <source>Simplifying the mesh</source>
        <translation>正在简化网格</translation>
    </message>
    <message>
        <source>Changing the mesh to so many triangles needs about %1 MB of memory, more than three quarters of this machine&apos;s. Ask for fewer triangles.</source>
        <translation>将网格改为这么多三角形约需 %1 MB 内存，超过本机内存的四分之三。请减少三角形数。</translation>
    </message>
    <message>
        <source>Subdividing the mesh</source>
        <translation>正在细分网格</translation>
    </message>
    <message>
        <source>A mesh cannot be changed to or from %1 triangles. Ask for at least one triangle.</source>
        <translation>网格的三角形数不能为 %1。请至少指定一个三角形。</translation>
    </message>
    <message>
        <source>The mesh &quot;%1&quot; has no surface that could be simplified or subdivided.</source>
        <translation>网格“%1”没有可简化或细分的表面。</translation>
    </message>
    <message>
        <source>The mesh &quot;%1&quot; cannot be changed to %2 triangles: its pieces hold together only down to %3. Ask for at least that many.</source>
        <translation>网格“%1”无法改为 %2 个三角形：其各部分最少只能减到 %3 个。请至少指定这么多。</translation>
    </message>
    <message>
        <source>Writing the file</source>
        <translation>正在写入文件</translation>
    </message>
    <message>
        <source>%1: meshes are written as .obj, .ply or .stl. Choose one of these endings.</source>
        <translation>%1：网格以 .obj、.ply 或 .stl 写入。请选择其中一种扩展名。</translation>
    </message>
    <message>
        <source>%1: the scene has too many triangles for one file of this format. Write an OBJ file.</source>
        <translation>%1：场景的三角形过多，此格式的一个文件装不下。请写入 OBJ 文件。</translation>
    </message>
    <message>
        <source>%1 ends after line %2, before everything that it promises. The file was cut off: fetch it again.</source>
        <translation>%1 在第 %2 行之后结束，内容不完整。文件被截断：请重新获取。</translation>
    </message>
    <message>
        <source>%1, line %2: &quot;%3&quot; is not a number that can stand here. Correct the line or export the file again.</source>
        <translation>%1 第 %2 行：“%3”不是此处允许的数字。请改正该行或重新导出文件。</translation>
    </message>
    <message>
        <source>The camera&apos;s eye, target and up must be finite numbers.</source>
        <translation>相机的视点、目标和上方向必须是有限数。</translation>
    </message>
    <message>
        <source>The camera&apos;s eye and target are the same point: move one of them.</source>
        <translation>相机的视点和目标是同一点：请移动其中一个。</translation>
    </message>
    <message>
        <source>The camera&apos;s up vector is zero: give it a direction.</source>
        <translation>相机的上方向向量为零：请给它一个方向。</translation>
    </message>
    <message>
        <source>The field of view must lie between 0 and 180 degrees, not %1.</source>
        <translation>视场角必须在 0 到 180 度之间，不能是 %1。</translation>
    </message>
    <message>
        <source>The near distance must be above 0 and below the far distance (near %1, far %2).</source>
        <translation>近距离必须大于 0 且小于远距离（近 %1，远 %2）。</translation>
    </message>
    <message>
        <source>A picture is 1 to 16384 pixels wide and high, not %1x%2.</source>
        <translation>图像的宽和高为 1 到 16384 像素，不能是 %1x%2。</translation>
    </message>
    <message>
        <source>The path %1 needs a number of poses between 1 and 1000000 after the colon.</source>
        <translation>路径 %1 的冒号后需要 1 到 1000000 之间的位姿数。</translation>
    </message>
    <message>
        <source>%1: pose %2: &quot;%3&quot; must be three numbers.</source>
        <translation>%1：位姿 %2：“%3”必须是三个数。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; must be a number.</source>
        <translation>%1：“%2”必须是数字。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither a camera path file nor a built-in path. Built in: orbit:N, fibonacci:N, walk:N, case-1, case-2, case-3.</source>
        <translation>“%1”既不是相机路径文件，也不是内置路径。内置路径：orbit:N、fibonacci:N、walk:N、case-1、case-2、case-3。</translation>
    </message>
    <message>
        <source>%1 cannot be opened: check the name and that you may read it.</source>
        <translation>无法打开 %1：请检查名称和读取权限。</translation>
    </message>
    <message>
        <source>%1 is not JSON: it breaks off at byte %2. A camera path has the fields fovy_deg, near, far and poses.</source>
        <translation>%1 不是 JSON：在第 %2 字节处中断。相机路径包含字段 fovy_deg、near、far 和 poses。</translation>
    </message>
    <message>
        <source>%1: a camera path needs a list &quot;poses&quot; with at least one pose.</source>
        <translation>%1：相机路径需要至少含一个位姿的列表“poses”。</translation>
    </message>
    <message>
        <source>%1: pose %2: %3</source>
        <translation>%1：位姿 %2：%3</translation>
    </message>
    <message>
        <source>N poses on a circle at three times the scene&apos;s radius, 15 degrees above it</source>
        <translation>位于场景半径三倍处、高出 15 度的圆上的 N 个位姿</translation>
    </message>
    <message>
        <source>N poses spread evenly around the scene at three times its radius</source>
        <translation>在场景半径三倍处均匀分布的 N 个位姿</translation>
    </message>
    <message>
        <source>N poses on a walk into the scene, looking ahead</source>
        <translation>向前看着走入场景的 N 个位姿</translation>
    </message>
    <message>
        <source>a close view with a pole of the spherical map in it</source>
        <translation>包含球面图一个极点的近景</translation>
    </message>
    <message>
        <source>a close view of one clump of the spherical map</source>
        <translation>球面图中一个团块的近景</translation>
    </message>
    <message>
        <source>a close view of a clump that the map&apos;s seam splits</source>
        <translation>被图的接缝分开的团块的近景</translation>
    </message>
    <message>
        <source>%1: %2=%3 is not a number between %4 and %5.</source>
        <translation>%1：%2=%3 不是 %4 到 %5 之间的数。</translation>
    </message>
    <message>
        <source>%1 has no parameter &quot;%2&quot;. It has: %3.</source>
        <translation>%1 没有参数“%2”。可用参数：%3。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not of the form key=value.</source>
        <translation>%1：“%2”不是 key=value 的形式。</translation>
    </message>
    <message>
        <source>No bunny is installed here. Install the package glmark2-data, or name a folder that holds bunny.obj with --models DIR or CULLSCOPE_MODELS.</source>
        <translation>这里没有安装兔子模型。请安装软件包 glmark2-data，或用 --models DIR 或 CULLSCOPE_MODELS 指定含有 bunny.obj 的文件夹。</translation>
    </message>
    <message>
        <source>mesh: names no file. Write mesh:FILE,triangles=N.</source>
        <translation>mesh: 未指定文件。请写成 mesh:FILE,triangles=N。</translation>
    </message>
    <message>
        <source>how many triangles, to the nearest that the shape&apos;s grid allows</source>
        <translation>三角形数（取形状网格允许的最接近值）</translation>
    </message>
    <message>
        <source>the Stanford bunny, from an installed model file</source>
        <translation>斯坦福兔子，来自已安装的模型文件</translation>
    </message>
    <message>
        <source>Newell&apos;s teapot, tessellated from its 32 Bézier patches</source>
        <translation>纽厄尔茶壶，由 32 个贝塞尔面片细分而成</translation>
    </message>
    <message>
        <source>a unit sphere, from an icosahedron</source>
        <translation>由正二十面体生成的单位球</translation>
    </message>
    <message>
        <source>a torus of radii 1 and 0.25: closed, not star-shaped</source>
        <translation>半径为 1 和 0.25 的圆环面：封闭，非星形</translation>
    </message>
    <message>
        <source>a tube around a torus knot: hides much of itself</source>
        <translation>沿环面纽结的管：大部分被自身遮挡</translation>
    </message>
    <message>
        <source>a star-shaped body with random bumps</source>
        <translation>带随机起伏的星形体</translation>
    </message>
    <message>
        <source>number that the random shape starts from</source>
        <translation>随机形状的种子数</translation>
    </message>
    <message>
        <source>a grid of n by n copies of a mesh, each of radius 1</source>
        <translation>由 n × n 个半径为 1 的网格副本排成的阵列</translation>
    </message>
    <message>
        <source>mesh file, or bunny</source>
        <translation>网格文件，或 bunny</translation>
    </message>
    <message>
        <source>copies along each side</source>
        <translation>每边的副本数</translation>
    </message>
    <message>
        <source>distance between neighbours</source>
        <translation>相邻副本的间距</translation>
    </message>
    <message>
        <source>a mesh file simplified or subdivided: mesh:FILE,triangles=N</source>
        <translation>简化或细分的网格文件：mesh:FILE,triangles=N</translation>
    </message>
    <message>
        <source>how many triangles to make of it</source>
        <translation>生成的三角形数</translation>
    </message>
    <message>
        <source>No scene is named. Give a mesh file or a generator such as bunny or sphere:triangles=1e5.</source>
        <translation>未指定场景。请给出网格文件或生成器，例如 bunny 或 sphere:triangles=1e5。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither a file nor a generator. Generators: %2.</source>
        <translation>“%1”既不是文件也不是生成器。生成器：%2。</translation>
    </message>
    <message>
        <source>All triangles</source>
        <translation>所有三角形</translation>
    </message>
    <message>
        <source>Draws every triangle, both sides: what the papers compare with.</source>
        <translation>双面绘制所有三角形：论文中的比较基准。</translation>
    </message>
    <message>
        <source>Back-face culling</source>
        <translation>背面剔除</translation>
    </message>
    <message>
        <source>Draws every triangle and lets OpenGL drop those that face away: the strong baseline.</source>
        <translation>绘制所有三角形，由 OpenGL 丢弃背向的面：有力的基准。</translation>
    </message>
    <message>
        <source>Which faces are drawn: both sides, or only those whose front is turned to the eye.</source>
        <translation>绘制哪些面：双面，或仅正面朝向视点的面。</translation>
    </message>
    <message>
        <source>front where every mesh is closed, else two-sided</source>
        <translation>所有网格都封闭时仅正面，否则双面</translation>
    </message>
    <message>
        <source>both sides</source>
        <translation>双面</translation>
    </message>
    <message>
        <source>front sides only</source>
        <translation>仅正面</translation>
    </message>
    <message>
        <source>View-frustum culling</source>
        <translation>视锥体剔除</translation>
    </message>
    <message>
        <source>Leaves out objects whose bounds lie outside one of the six planes of the view.</source>
        <translation>略去包围体位于视锥体六个平面之一外侧的物体。</translation>
    </message>
    <message>
        <source>How a bounding box is tested against a plane.</source>
        <translation>包围盒与平面的测试方法。</translation>
    </message>
    <message>
        <source>by its corner farthest inside</source>
        <translation>用最靠内侧的角点</translation>
    </message>
    <message>
        <source>by the length of its extent vector (wastes corners)</source>
        <translation>用范围向量的长度（角部有浪费）</translation>
    </message>
    <message>
        <source>%1=%2: %1 is true or false.</source>
        <translation>%1=%2：%1 只能是 true 或 false。</translation>
    </message>
    <message>
        <source>%1=%2: %1 is one of %3.</source>
        <translation>%1=%2：%1 只能是 %3 之一。</translation>
    </message>
    <message>
        <source>%1=%2: %1 is a whole number between %3 and %4.</source>
        <translation>%1=%2：%1 是 %3 到 %4 之间的整数。</translation>
    </message>
    <message>
        <source>%1=%2: %1 is a number between %3 and %4.</source>
        <translation>%1=%2：%1 是 %3 到 %4 之间的数。</translation>
    </message>
    <message>
        <source>There is no parameter &quot;%1&quot; here. Known: %2.</source>
        <translation>这里没有参数“%1”。已知：%2。</translation>
    </message>
    <message>
        <source>There is no strategy &quot;%1&quot;. Known: %2.</source>
        <translation>没有策略“%1”。已知：%2。</translation>
    </message>
    <message>
        <source>outside the frustum</source>
        <translation>视锥体之外</translation>
    </message>
    <message>
        <source>back-facing</source>
        <translation>背向</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>被遮挡</translation>
    </message>
    <message>
        <source>too small</source>
        <translation>过小</translation>
    </message>
    <message>
        <source>There is not enough memory to draw this view. Make the window or the scene smaller.</source>
        <translation>内存不足，无法绘制此视图。请缩小窗口或使用更小的场景。</translation>
    </message>
    <message>
        <source>This view cannot be drawn: %1</source>
        <translation>无法绘制此视图：%1</translation>
    </message>
    <message>
        <source>%1 is a folder or a device: name a file to write.</source>
        <translation>%1 是文件夹或设备：请指定要写入的文件。</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>没有这样的文件或文件夹</translation>
    </message>
    <message>
        <source>a part of the path is no folder</source>
        <translation>路径中的一部分不是文件夹</translation>
    </message>
    <message>
        <source>permission is denied</source>
        <translation>没有权限</translation>
    </message>
    <message>
        <source>the place is read-only</source>
        <translation>该位置是只读的</translation>
    </message>
    <message>
        <source>no space is left</source>
        <translation>没有剩余空间</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>它是一个文件夹</translation>
    </message>
    <message>
        <source>the name is too long</source>
        <translation>名称过长</translation>
    </message>
    <message>
        <source>the device reports an error</source>
        <translation>设备报告了错误</translation>
    </message>
    <message>
        <source>The picture cannot be made: %1.</source>
        <translation>无法生成图像：%1。</translation>
    </message>
    <message>
        <source>%1 takes between %2 and %3 triangles, not %4.</source>
        <translation>%1 的三角形数须在 %2 到 %3 之间，不能是 %4。</translation>
    </message>
    <message>
        <source>Tessellating the shape</source>
        <translation>正在细分形状</translation>
    </message>
    <message>
        <source>%1 is no camera path file that can be read: check the name.</source>
        <translation>%1 不是可读取的相机路径文件：请检查名称。</translation>
    </message>
    <message>
        <source>%1 holds a number that is too large. A camera path has the fields fovy_deg, near, far and poses.</source>
        <translation>%1 含有过大的数。相机路径包含字段 fovy_deg、near、far 和 poses。</translation>
    </message>
    <message>
        <source>%1: %2 has no value.</source>
        <translation>%1：%2 没有值。</translation>
    </message>
    <message>
        <source>%1: %2 is a whole number, not %3.</source>
        <translation>%1：%2 是整数，不能是 %3。</translation>
    </message>
    <message>
        <source>%1 triangles were made where %2 were asked for: a closed mesh has an even number.</source>
        <translation>要求 %2 个三角形，实际生成 %1 个：封闭网格的三角形数是偶数。</translation>
    </message>
    <message>
        <source>listing</source>
        <translation>列出</translation>
    </message>
    <message>
        <source>plane tests</source>
        <translation>平面测试</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::AboutDialog</name>
    <message>
        <source>About Cullscope</source>
        <translation>关于 Cullscope</translation>
    </message>
    <message>
        <source>Shows what each culling strategy draws, how fast, and what it loses, measured against what is truly visible.</source>
        <translation>显示每种剔除策略绘制了什么、有多快、丢失了什么，并以真实可见的内容为基准进行度量。</translation>
    </message>
    <message>
        <source>Qt %1
OpenGL %2
%3</source>
        <comment>versions, then the OpenGL renderer</comment>
        <translation>Qt %1
OpenGL %2
%3</translation>
    </message>
    <message>
        <source>Cullscope&apos;s own sources are under the MIT licence.</source>
        <translation>Cullscope 自身的源代码采用 MIT 许可证。</translation>
    </message>
    <message>
        <source>It uses Qt under the LGPL version 3, linked dynamically: you may replace Qt by a version of your own. This program does not link Qt Charts, which is under the GPL version 3; a program that links it is under the GPL version 3 as a whole.</source>
        <translation>本程序依据 LGPL 第 3 版以动态链接方式使用 Qt：您可以换用自己的 Qt 版本。本程序未链接采用 GPL 第 3 版的 Qt Charts；链接它的程序整体须遵循 GPL 第 3 版。</translation>
    </message>
    <message>
        <source>Also: OpenMesh and libepoxy, GLM, tinyobjloader, OpenImageIO, Embree, oneTBB, OpenSSL, CLI11, nlohmann-json and fmt, each under its own free licence.</source>
        <translation>此外还使用 OpenMesh、libepoxy、GLM、tinyobjloader、OpenImageIO、Embree、oneTBB、OpenSSL、CLI11、nlohmann-json 和 fmt，它们各自采用自由许可证。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::EmptyState</name>
    <message>
        <source>Opening the scene…</source>
        <translation>正在打开场景…</translation>
    </message>
    <message>
        <source>Open a mesh or generate a scene</source>
        <translation>打开网格或生成场景</translation>
    </message>
    <message>
        <source>The window can be used meanwhile.</source>
        <translation>在此期间可以继续使用窗口。</translation>
    </message>
    <message>
        <source>Drop a file here (%1), or start from a built-in scene.</source>
        <translation>将文件（%1）拖放到这里，或从内置场景开始。</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>打开文件…</translation>
    </message>
    <message>
        <source>Generate</source>
        <translation>生成</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::FigureModel</name>
    <message>
        <source>Speed against backface</source>
        <translation>相对 backface 的速度</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation>每秒帧数</translation>
    </message>
    <message>
        <source>Culling</source>
        <translation>剔除</translation>
    </message>
    <message>
        <source>Submitted triangles</source>
        <translation>提交的三角形</translation>
    </message>
    <message>
        <source>Visible triangles</source>
        <translation>可见的三角形</translation>
    </message>
    <message>
        <source>Drawn in vain</source>
        <translation>白画的三角形</translation>
    </message>
    <message>
        <source>Missed pixels</source>
        <translation>丢失的像素</translation>
    </message>
    <message>
        <source>Largest hole</source>
        <translation>最大的空洞</translation>
    </message>
    <message>
        <source>Covered pixels</source>
        <translation>覆盖的像素</translation>
    </message>
    <message>
        <source>Frame time of the strategy backface divided by this strategy&apos;s, measured in turns at the same camera</source>
        <translation>在同一相机下交替测量：backface 策略的帧时间除以本策略的帧时间</translation>
    </message>
    <message>
        <source>Culling and drawing into the view&apos;s own picture until OpenGL has finished; the window itself is not counted</source>
        <translation>剔除并绘制到视图自身的图像，直到 OpenGL 完成为止；不含窗口显示的时间</translation>
    </message>
    <message>
        <source>1 / (cull + draw)</source>
        <translation>1 /（剔除 + 绘制）</translation>
    </message>
    <message>
        <source>Time in which the strategy decides what to draw</source>
        <translation>策略决定绘制内容所用的时间</translation>
    </message>
    <message>
        <source>Triangles given to OpenGL</source>
        <translation>交给 OpenGL 的三角形</translation>
    </message>
    <message>
        <source>Triangles that truly show in at least one pixel</source>
        <translation>至少在一个像素中真实可见的三角形</translation>
    </message>
    <message>
        <source>Submitted triangles that show in no pixel</source>
        <translation>已提交但在任何像素中都不可见的三角形</translation>
    </message>
    <message>
        <source>Pixels in which the truth has a surface and this picture a farther one or none</source>
        <translation>真实结果中有表面，而此图像中是更远的表面或什么也没有的像素</translation>
    </message>
    <message>
        <source>Pixels of the largest connected group of missed pixels</source>
        <translation>丢失像素中最大连通块的像素数</translation>
    </message>
    <message>
        <source>Pixels in which the truth has a surface</source>
        <translation>真实结果中有表面的像素</translation>
    </message>
    <message>
        <source>– beyond snapping</source>
        <translation>– 超出对齐误差</translation>
    </message>
    <message>
        <source>Missed pixels that the raster&apos;s snapping of vertices to 1/256 pixel does not explain; counted where the strategy draws front faces only and the truth both sides</source>
        <translation>无法用光栅将顶点对齐到 1/256 像素来解释的丢失像素；在策略只画正面而真实结果画双面时统计</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::FigurePanel</name>
    <message>
        <source>Figures</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>Software OpenGL: not the times of a graphics card</source>
        <translation>软件 OpenGL：并非显卡的时间</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::GenerateDialog</name>
    <message>
        <source>Generate a scene: %1</source>
        <translation>生成场景：%1</translation>
    </message>
    <message>
        <source>Generate</source>
        <translation>生成</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::KeysDialog</name>
    <message>
        <source>Mouse and keys</source>
        <translation>鼠标和按键</translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation>左键拖动</translation>
    </message>
    <message>
        <source>turn about the centre of rotation</source>
        <translation>绕旋转中心转动</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>滚轮</translation>
    </message>
    <message>
        <source>zoom to the pointer</source>
        <translation>以指针为中心缩放</translation>
    </message>
    <message>
        <source>Middle drag, or Shift + left drag</source>
        <translation>中键拖动，或 Shift + 左键拖动</translation>
    </message>
    <message>
        <source>pan</source>
        <translation>平移</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>双击</translation>
    </message>
    <message>
        <source>set the centre of rotation</source>
        <translation>设置旋转中心</translation>
    </message>
    <message>
        <source>Right drag</source>
        <translation>右键拖动</translation>
    </message>
    <message>
        <source>look around</source>
        <translation>环顾四周</translation>
    </message>
    <message>
        <source>W A S D, Q E</source>
        <translation>W A S D、Q E</translation>
    </message>
    <message>
        <source>fly forward, left, back, right, down, up (Shift: faster)</source>
        <translation>向前、左、后、右、下、上飞行（Shift：加速）</translation>
    </message>
    <message>
        <source>Ctrl + wheel</source>
        <translation>Ctrl + 滚轮</translation>
    </message>
    <message>
        <source>near plane</source>
        <translation>近裁剪面</translation>
    </message>
    <message>
        <source>Shift + wheel</source>
        <translation>Shift + 滚轮</translation>
    </message>
    <message>
        <source>field of view</source>
        <translation>视场角</translation>
    </message>
    <message>
        <source>Right click, or the menu key</source>
        <translation>右键单击，或菜单键</translation>
    </message>
    <message>
        <source>menu of the view</source>
        <translation>视图菜单</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>方向键</translation>
    </message>
    <message>
        <source>turn; with Shift: pan</source>
        <translation>转动；按住 Shift：平移</translation>
    </message>
    <message>
        <source>+ and −</source>
        <translation>+ 和 −</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>back to the first view</source>
        <translation>回到初始视角</translation>
    </message>
    <message>
        <source>. (full stop)</source>
        <translation>.（句点）</translation>
    </message>
    <message>
        <source>show the whole scene</source>
        <translation>显示整个场景</translation>
    </message>
    <message>
        <source>Ctrl + 1, Ctrl + 2</source>
        <translation>Ctrl + 1、Ctrl + 2</translation>
    </message>
    <message>
        <source>one view, two views</source>
        <translation>一个视图、两个视图</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>next view or panel</source>
        <translation>下一个视图或面板</translation>
    </message>
    <message>
        <source>Ctrl + O</source>
        <translation>Ctrl + O</translation>
    </message>
    <message>
        <source>open a file</source>
        <translation>打开文件</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>this page</source>
        <translation>本页</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::LegendPanel</name>
    <message>
        <source>Next: open a mesh file, or generate a scene.</source>
        <translation>下一步：打开网格文件，或生成场景。</translation>
    </message>
    <message>
        <source>Next: drag in a picture to turn the scene.</source>
        <translation>下一步：在图像中拖动以转动场景。</translation>
    </message>
    <message>
        <source>Next: turn the wheel over the scene to zoom in until part of it lies outside the picture.</source>
        <translation>下一步：在场景上滚动滚轮放大，直到一部分超出图像。</translation>
    </message>
    <message>
        <source>Next: choose another strategy above and compare the figures over the pictures.</source>
        <translation>下一步：在上方选择另一种策略，比较图像上方的数据。</translation>
    </message>
    <message>
        <source>Next: press H to see all keys, or open a model of your own.</source>
        <translation>下一步：按 H 查看所有按键，或打开您自己的模型。</translation>
    </message>
    <message>
        <source>Over each picture: speed against backface · triangles submitted · pixels missed</source>
        <translation>图像上方：相对 backface 的速度 · 提交的三角形 · 丢失的像素</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>promise, its meaning</comment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::LoadingStrip</name>
    <message>
        <source>Opening %1</source>
        <translation>正在打开 %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>opening what, stage</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Stop opening and keep the present scene</source>
        <translation>停止打开并保留当前场景</translation>
    </message>
    <message>
        <source>Progress of opening</source>
        <translation>打开进度</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::MainWindow</name>
    <message>
        <source>%1 – Cullscope</source>
        <translation>%1 – Cullscope</translation>
    </message>
    <message>
        <source>Strategy and figures</source>
        <translation>策略与数据</translation>
    </message>
    <message>
        <source>Toolbar</source>
        <translation>工具栏</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Software OpenGL</source>
        <translation>软件 OpenGL</translation>
    </message>
    <message>
        <source>The processor draws: times are not those of a graphics card.</source>
        <translation>由处理器绘制：所示时间并非显卡的时间。</translation>
    </message>
    <message>
        <source>Open a mesh file</source>
        <translation>打开网格文件</translation>
    </message>
    <message>
        <source>Copy the picture</source>
        <translation>复制图像</translation>
    </message>
    <message>
        <source>Copy the cullbench command</source>
        <translation>复制 cullbench 命令</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>策略</translation>
    </message>
    <message>
        <source>Figures and scene</source>
        <translation>数据和场景</translation>
    </message>
    <message>
        <source>Meshes (%1)</source>
        <translation>网格（%1）</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>所有文件</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>关闭此消息</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ParameterForm</name>
    <message>
        <source>This strategy has no parameters.</source>
        <translation>此策略没有参数。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::SceneModel</name>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Different meshes</source>
        <translation>不同的网格</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>内存</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ScenePanel</name>
    <message>
        <source>Facts of the scene</source>
        <translation>场景信息</translation>
    </message>
    <message>
        <source>What was found in the file</source>
        <translation>文件中发现的问题</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::StrategyPanel</name>
    <message>
        <source>Strategy of view %1</source>
        <translation>视图 %1 的策略</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>策略</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ViewHeader</name>
    <message>
        <source>%1: %2</source>
        <comment>strategy: promise</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Compare this large scene with the truth now; this may take a while</source>
        <translation>立即将此大型场景与真实结果比较；可能需要一些时间</translation>
    </message>
    <message>
        <source>Promise: %1, %2</source>
        <comment>word, sentence</comment>
        <translation>承诺：%1，%2</translation>
    </message>
    <message>
        <source>View %1: %2, %3</source>
        <comment>letter, strategy and promise, figures</comment>
        <translation>视图 %1：%2，%3</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ViewPane</name>
    <message>
        <source>near plane %1</source>
        <translation>近裁剪面 %1</translation>
    </message>
    <message>
        <source>field of view %1°</source>
        <translation>视场角 %1°</translation>
    </message>
    <message>
        <source>%1 (Home resets)</source>
        <translation>%1（Home 键重置）</translation>
    </message>
    <message>
        <source>Picture of view %1</source>
        <translation>视图 %1 的图像</translation>
    </message>
    <message>
        <source>Arrow keys turn, plus and minus zoom, Shift with arrow keys pans, W A S D Q E fly.</source>
        <translation>方向键转动，加号和减号缩放，Shift 加方向键平移，W A S D Q E 飞行。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::WindowActions</name>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Up axis</source>
        <translation>向上轴(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>外观(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>语言(&amp;L) / Language</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Generate</source>
        <translation>生成(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>Open a mesh file</source>
        <translation>打开网格文件</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>Leave the program</source>
        <translation>退出程序</translation>
    </message>
    <message>
        <source>&amp;1 view</source>
        <translation>1 个视图(&amp;1)</translation>
    </message>
    <message>
        <source>Show one view</source>
        <translation>显示一个视图</translation>
    </message>
    <message>
        <source>&amp;2 views</source>
        <translation>2 个视图(&amp;2)</translation>
    </message>
    <message>
        <source>Show two views beside each other</source>
        <translation>并排显示两个视图</translation>
    </message>
    <message>
        <source>&amp;Home</source>
        <translation>初始视角(&amp;H)</translation>
    </message>
    <message>
        <source>Back to the first view of the scene</source>
        <translation>回到场景的初始视角</translation>
    </message>
    <message>
        <source>&amp;Frame the scene</source>
        <translation>适合场景(&amp;F)</translation>
    </message>
    <message>
        <source>Show the whole scene from the present direction</source>
        <translation>从当前方向显示整个场景</translation>
    </message>
    <message>
        <source>&amp;y up</source>
        <translation>y 轴(&amp;Y)</translation>
    </message>
    <message>
        <source>The y axis points up</source>
        <translation>y 轴朝上</translation>
    </message>
    <message>
        <source>&amp;z up</source>
        <translation>z 轴(&amp;Z)</translation>
    </message>
    <message>
        <source>The z axis points up</source>
        <translation>z 轴朝上</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>跟随系统(&amp;S)</translation>
    </message>
    <message>
        <source>Light or dark as the system is set</source>
        <translation>按系统设置使用浅色或深色</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>浅色(&amp;L)</translation>
    </message>
    <message>
        <source>Dark on light</source>
        <translation>浅底深字</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>深色(&amp;D)</translation>
    </message>
    <message>
        <source>Light on dark</source>
        <translation>深底浅字</translation>
    </message>
    <message>
        <source>Mouse and &amp;keys</source>
        <translation>鼠标和按键(&amp;K)</translation>
    </message>
    <message>
        <source>Show all mouse moves and keys</source>
        <translation>显示所有鼠标操作和按键</translation>
    </message>
    <message>
        <source>&amp;About Cullscope</source>
        <translation>关于 Cullscope(&amp;A)</translation>
    </message>
    <message>
        <source>Version and licences</source>
        <translation>版本和许可证</translation>
    </message>
</context>
</TS>
