<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>HtmlReport</name>
    <message>
        <source>until the median is steady</source>
        <translation>直到中位数稳定</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Camera path</source>
        <translation>相机路径</translation>
    </message>
    <message>
        <source>Poses measured</source>
        <translation>已测姿态</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%2 个中的 %1 个</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>Pictures a frame</source>
        <translation>每帧图像数</translation>
    </message>
    <message>
        <source>Repetitions</source>
        <translation>重复次数</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>处理器</translation>
    </message>
    <message>
        <source>Software OpenGL: not the times of a graphics card</source>
        <translation>软件 OpenGL：不是显卡的时间</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Promise</source>
        <translation>承诺</translation>
    </message>
    <message>
        <source>: broken</source>
        <translation>：未兑现</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>策略</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>姿态</translation>
    </message>
    <message>
        <source>Frame, ms</source>
        <translation>帧，ms</translation>
    </message>
    <message>
        <source>Cull, ms</source>
        <translation>剔除，ms</translation>
    </message>
    <message>
        <source>Submitted</source>
        <translation>提交</translation>
    </message>
    <message>
        <source>Missed pixels</source>
        <translation>丢失像素</translation>
    </message>
    <message>
        <source>Covered pixels</source>
        <translation>覆盖像素</translation>
    </message>
    <message>
        <source>Cullscope: what culling gains and loses in %1</source>
        <translation>Cullscope：剔除在 %1 中的得与失</translation>
    </message>
    <message>
        <source>stopped early: the poses measured until then</source>
        <translation>提前停止：截至当时测得的姿态</translation>
    </message>
    <message>
        <source>The command that repeats it</source>
        <translation>可重现此结果的命令</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Every frame</source>
        <translation>所有帧</translation>
    </message>
    <message>
        <source>Conclusion</source>
        <translation>结论</translation>
    </message>
    <message>
        <source>The scene, as the active view showed it</source>
        <translation>活动视图所显示的场景</translation>
    </message>
    <message>
        <source>Errors in the field&apos;s figures, with their 95 % intervals</source>
        <translation>以领域常用指标表示的误差及其 95 % 区间</translation>
    </message>
</context>
<context>
    <name>Screenshot</name>
    <message>
        <source>%1: %2</source>
        <comment>what a colour means, how many</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>farther away than beside it, or missing (pixels)</source>
        <translation>比旁边更远或缺失（像素）</translation>
    </message>
    <message>
        <source>nearer than beside it (pixels)</source>
        <translation>比旁边更近（像素）</translation>
    </message>
    <message>
        <source>software OpenGL</source>
        <translation>软件 OpenGL</translation>
    </message>
    <message>
        <source>box rejected by the %1</source>
        <comment>name of a plane</comment>
        <translation>剔除该盒的平面：%1</translation>
    </message>
    <message>
        <source>figures at %1 pixels</source>
        <translation>%1 像素下的数据</translation>
    </message>
    <message>
        <source>Triangles at %1 pixels:</source>
        <comment>heading of the legend&apos;s counts, size</comment>
        <translation>%1 像素下的三角形：</translation>
    </message>
    <message>
        <source>within snapping, not lost (pixels)</source>
        <translation>对齐误差之内，不算丢失（像素）</translation>
    </message>
</context>
<context>
    <name>SphericalModel</name>
    <message>
        <source>R: near</source>
        <translation>R：近</translation>
    </message>
    <message>
        <source>far</source>
        <translation>远</translation>
    </message>
    <message>
        <source>Only what the strategy submits is drawn: choose All triangles for the whole model.</source>
        <translation>只绘制策略提交的内容：要看整个模型，请选择“所有三角形”。</translation>
    </message>
</context>
<context>
    <name>ViewMenu</name>
    <message>
        <source>Strategy</source>
        <translation>策略</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Linked with the other views</source>
        <translation>与其他视图联动</translation>
    </message>
    <message>
        <source>Watch view %1 from outside</source>
        <translation>从外部观察视图 %1</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Wipe: view %1 | this one</source>
        <translation>对比：视图 %1 | 本视图</translation>
    </message>
    <message>
        <source>Pixels that differ from view %1</source>
        <translation>与视图 %1 不同的像素</translation>
    </message>
    <message>
        <source>Picture size</source>
        <translation>图像大小</translation>
    </message>
    <message>
        <source>The same in all views</source>
        <translation>所有视图相同</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>Buffer objects</source>
        <translation>缓冲区对象</translation>
    </message>
    <message>
        <source>Vertex arrays of the program&apos;s memory</source>
        <translation>程序内存中的顶点数组</translation>
    </message>
    <message>
        <source>Vertex arrays: this OpenGL has no compatibility profile</source>
        <translation>顶点数组：此 OpenGL 没有兼容性配置文件</translation>
    </message>
    <message>
        <source>In this place</source>
        <translation>在此处</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>Below the picture</source>
        <translation>图像下方</translation>
    </message>
    <message>
        <source>Other…</source>
        <translation>其他…</translation>
    </message>
    <message>
        <source>Other (%1)…</source>
        <translation>其他（%1）…</translation>
    </message>
    <message>
        <source>Fits the window</source>
        <translation>适应窗口</translation>
    </message>
</context>
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
        <extracomment>Line 2 of a view&apos;s header: speed against the baseline, share of the triangles submitted, missed pixels.</extracomment>
        <translation>%1 · %2 % · 丢失 %3</translation>
    </message>
    <message>
        <source>Speed: %1 fps = 1 / (cull + draw), %2 a frame, of which %3 culling</source>
        <translation>速度：%1 fps = 1 /（剔除 + 绘制），每帧 %2，其中剔除 %3</translation>
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
        <source>Submitted in %1 fragments that the strategy made of them</source>
        <translation>以策略生成的 %1 个三角形碎片提交</translation>
    </message>
    <message>
        <source>In force, to hold the frame time: %1</source>
        <translation>为保持帧时间而当前生效的值：%1</translation>
    </message>
    <message>
        <source>Within the raster&apos;s snapping, and not lost: %1</source>
        <extracomment>Pixels that differ from the truth&apos;s only because OpenGL rounds corners to 1/256 pixel.</extracomment>
        <translation>在光栅的对齐误差之内，不算丢失：%1</translation>
    </message>
    <message>
        <source>%1 against %2, which draws the same sides, with its 95 % interval</source>
        <extracomment>Speed against a baseline, %2, and its 95 % interval: &quot;×3.1 (2.93 – 3.31)&quot;.</extracomment>
        <translation>相对绘制相同面的 %2：%1，附 95 % 区间</translation>
    </message>
    <message>
        <source>%1 against %2, which draws front faces only</source>
        <extracomment>The same against a baseline that draws front faces alone.</extracomment>
        <translation>相对只绘制正面的 %2：%1</translation>
    </message>
    <message>
        <source>front faces only of closed objects, both sides of the others</source>
        <translation>封闭物体只绘制正面，其余绘制两面</translation>
    </message>
    <message>
        <source>Submitted: %1 of %2 triangles. Visible, drawn or not: %3</source>
        <translation>提交：%2 个三角形中的 %1 个。可见的（无论是否绘制）：%3</translation>
    </message>
    <message>
        <source>Which one is faster is not decided.</source>
        <translation>无法确定哪个更快。</translation>
    </message>
    <message>
        <source>%1 is %2 times as fast as %3.</source>
        <extracomment>A view&apos;s letter, how many times as fast, another view&apos;s letter.</extracomment>
        <translation>%1 的速度是 %3 的 %2 倍。</translation>
    </message>
    <message>
        <source>%1 is %2 times as fast as %3 (%4).</source>
        <extracomment>The same with the 95 % interval.</extracomment>
        <translation>%1 的速度是 %3 的 %2 倍（%4）。</translation>
    </message>
    <message>
        <source>Any culling could gain at most %1 against %2: the visible triangles alone</source>
        <extracomment>What drawing exactly the visible triangles gains over a baseline, %2, and its 95 % interval: &quot;×3.1 (2.93 – 3.31)&quot;.</extracomment>
        <translation>任何剔除至多可达：相对于 %2 为 %1，即只绘制可见三角形</translation>
    </message>
    <message>
        <source>Of this headroom: %1</source>
        <extracomment>The share of what any culling could gain that this strategy gains.</extracomment>
        <translation>占此余地的比例：%1</translation>
    </message>
    <message>
        <source>Nothing could be gained here: drawing the visible triangles alone is %1 against %2</source>
        <extracomment>The speed of drawing exactly the visible triangles over a baseline, %2, and its 95 % interval: &quot;×0.92 (0.81 – 1.02)&quot;.</extracomment>
        <translation>此处没有可获得的：只绘制可见三角形相对于 %2 为 %1</translation>
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
        <translation>相机路径中没有姿态。</translation>
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
        <source>%1 is compressed twice. Unpack it once: xz -dk &quot;%1&quot; or gzip -dk &quot;%1&quot;.</source>
        <translation>%1 被压缩了两次。请先解压一次：xz -dk &quot;%1&quot; 或 gzip -dk &quot;%1&quot;。</translation>
    </message>
    <message>
        <source>%1 unpacks to more than the %2 MB that may be used on this machine. Simplify the mesh or split the file.</source>
        <translation>%1 解压后超过本机可用的 %2 MB。请简化网格或拆分文件。</translation>
    </message>
    <message>
        <source>%1, byte %2: the compressed data are damaged. Fetch the file again.</source>
        <translation>%1，字节 %2：压缩数据已损坏。请重新获取文件。</translation>
    </message>
    <message>
        <source>%1 ends at byte %2, within its compressed data. The file was cut off: fetch it again.</source>
        <translation>%1 在压缩数据中的字节 %2 处结束。文件被截断：请重新获取。</translation>
    </message>
    <message>
        <source>%1, byte %2: unpacking the file takes more memory than may be used on this machine. Compress it anew by a lower level, such as xz -6.</source>
        <translation>%1，字节 %2：解压该文件所需内存超过本机可用的量。请用较低级别重新压缩，例如 xz -6。</translation>
    </message>
    <message>
        <source>Unpacking the file</source>
        <translation>正在解压文件</translation>
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
        <translation>路径 %1 的冒号后需要 1 到 1000000 之间的姿态数。</translation>
    </message>
    <message>
        <source>%1: pose %2: &quot;%3&quot; must be three numbers.</source>
        <translation>%1：姿态 %2：“%3”必须是三个数。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; must be a number.</source>
        <translation>%1：“%2”必须是数字。</translation>
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
        <translation>%1：相机路径需要至少含一个姿态的列表“poses”。</translation>
    </message>
    <message>
        <source>%1: pose %2: %3</source>
        <translation>%1：姿态 %2：%3</translation>
    </message>
    <message>
        <source>N poses on a circle at three times the scene&apos;s radius, 15 degrees above it</source>
        <translation>位于场景半径三倍处、高出 15 度的圆上的 N 个姿态</translation>
    </message>
    <message>
        <source>N poses spread evenly around the scene at three times its radius</source>
        <translation>在场景半径三倍处均匀分布的 N 个姿态</translation>
    </message>
    <message>
        <source>N poses on a walk into the scene, looking ahead</source>
        <translation>向前看着走入场景的 N 个姿态</translation>
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
        <translation>剔除包围体位于视锥体六个平面之一外侧的物体。</translation>
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
    <message>
        <source>No camera path was recorded yet: record one, or add the present camera to it.</source>
        <translation>还没有录制相机路径：请录制一条，或把当前相机加入其中。</translation>
    </message>
    <message>
        <source>There is not enough memory for this experiment. Choose a smaller scene.</source>
        <translation>内存不足，无法进行此实验。请选择较小的场景。</translation>
    </message>
    <message>
        <source>The experiment cannot be run: %1</source>
        <translation>无法运行实验：%1</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot;: %3</source>
        <translation>%1：“%2”：%3</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; must be one of these words: %3.</source>
        <translation>%1：“%2”必须是以下词之一：%3。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; must be a group of fields in braces.</source>
        <translation>%1：“%2”必须是花括号中的一组字段。</translation>
    </message>
    <message>
        <source>%1: the field &quot;%2&quot; is missing.</source>
        <translation>%1：缺少字段“%2”。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; must be a list of 1 to %3 entries.</source>
        <translation>%1：“%2”必须是含 1 到 %3 项的列表。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; must be a number between %3 and %4.</source>
        <translation>%1：“%2”必须是 %3 到 %4 之间的数。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; must be a whole number between %3 and %4.</source>
        <translation>%1：“%2”必须是 %3 到 %4 之间的整数。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; must be true or false.</source>
        <translation>%1：“%2”必须是 true 或 false。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; must be a text in quotes.</source>
        <translation>%1：“%2”必须是引号中的文字。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; must be three numbers.</source>
        <translation>%1：“%2”必须是三个数。</translation>
    </message>
    <message>
        <source>There is not enough memory to draw this view. Make the picture or the scene smaller.</source>
        <translation>内存不足，无法绘制此视图。请缩小图像或场景。</translation>
    </message>
    <message>
        <source>There is no memory for a picture of %1x%2 pixels: choose a smaller size.</source>
        <translation>没有内存用于 %1x%2 像素的图像：请选择更小的尺寸。</translation>
    </message>
    <message>
        <source>%1 is not there any more; it was taken off the list of recent files.</source>
        <translation>%1 已不存在，已从最近文件列表中移除。</translation>
    </message>
    <message>
        <source>There is no memory for this picture: choose a smaller size.</source>
        <translation>没有内存用于此图像：请选择更小的尺寸。</translation>
    </message>
    <message>
        <source>A picture of %1x%2 pixels is too large: at most 16384 pixels a side can be saved.</source>
        <translation>%1x%2 像素的图像太大：每边最多可保存 16384 像素。</translation>
    </message>
    <message>
        <source>In %1x%2 pixels there is no room for the pictures beside legend and caption: choose a larger size or leave those out.</source>
        <translation>%1x%2 像素中除图例和说明外没有图像的位置：请选择更大的尺寸或去掉它们。</translation>
    </message>
    <message>
        <source>There is no picture to save yet: open a scene and wait until it is drawn.</source>
        <translation>还没有可保存的图像：请打开场景并等待绘制完成。</translation>
    </message>
    <message>
        <source>There is no folder %1: choose another one.</source>
        <translation>没有文件夹 %1：请选择另一个。</translation>
    </message>
    <message>
        <source>Nothing can be written into the folder %1: choose another one.</source>
        <translation>无法写入文件夹 %1：请选择另一个。</translation>
    </message>
    <message>
        <source>The file has no name: give it one, such as {scene}-{n}.png.</source>
        <translation>文件没有名称：请命名，例如 {scene}-{n}.png。</translation>
    </message>
    <message>
        <source>%1 is no session that can be read: it is not JSON from byte %2 on.</source>
        <translation>%1 不是可读取的会话：从第 %2 字节起不是 JSON。</translation>
    </message>
    <message>
        <source>%1 is no session that can be read: a number in it is too large.</source>
        <translation>%1 不是可读取的会话：其中有一个数过大。</translation>
    </message>
    <message>
        <source>%1 was saved by a newer Cullscope: install that one to open it.</source>
        <translation>%1 由更新版本的 Cullscope 保存：请安装该版本后再打开。</translation>
    </message>
    <message>
        <source>name a mesh file or a generator such as bunny.</source>
        <translation>请指定网格文件或 bunny 之类的生成器。</translation>
    </message>
    <message>
        <source>a view can watch only another one that is no observer itself.</source>
        <translation>视图只能观察另一个本身不是观察者的视图。</translation>
    </message>
    <message>
        <source>the near distance must be above 0.</source>
        <translation>近平面距离必须大于 0。</translation>
    </message>
    <message>
        <source>There is no scene to save yet: open one first.</source>
        <translation>还没有可保存的场景：请先打开一个。</translation>
    </message>
    <message>
        <source>The name of the scene&apos;s file is no UTF-8, which a session needs: rename the file.</source>
        <translation>场景文件的名称不是会话所需的 UTF-8：请重命名该文件。</translation>
    </message>
    <message>
        <source>%1 is no session that Cullscope saved. Open a mesh, a session, or a picture of Cullscope.</source>
        <translation>%1 不是 Cullscope 保存的会话。请打开网格、会话或 Cullscope 的图片。</translation>
    </message>
    <message>
        <source>%1 does not say what it shows: only pictures that Cullscope saved can be opened.</source>
        <translation>%1 没有说明其显示的内容：只能打开由 Cullscope 保存的图片。</translation>
    </message>
    <message>
        <source>The scene has %1 objects now, no longer %2: all of them are shown.</source>
        <translation>场景现在有 %1 个物体，不再是 %2 个：全部显示。</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>已保存 %1。</translation>
    </message>
    <message>
        <source>File names have no field {%1}. There are {scene}, {strategy}, {n} and {n:04}.</source>
        <translation>文件名没有占位符 {%1}。可用的有 {scene}、{strategy}、{n} 和 {n:04}。</translation>
    </message>
    <message>
        <source>%1 exists already: put {n} into the file name, and every picture gets a number of its own.</source>
        <translation>%1 已存在：在文件名中加入 {n}，每张图像就会有自己的编号。</translation>
    </message>
    <message>
        <source>Colours by verdict need %1 bytes in one buffer and this OpenGL gives %2: show the scene shaded, or a part of it.</source>
        <translation>按判定着色需要单个缓冲区 %1 字节，而此 OpenGL 只提供 %2 字节：请以着色方式显示场景，或只显示一部分。</translation>
    </message>
    <message>
        <source>%1: what the picture shows takes %2 bytes to describe, and this format holds %3. Write a .png or .exr file.</source>
        <translation>%1：描述图像内容需要 %2 字节，而此格式只能容纳 %3 字节。请写成 .png 或 .exr 文件。</translation>
    </message>
    <message>
        <source>%1 is %2x%3 pixels large or no flat picture: pictures of 1 to 16384 pixels a side are read.</source>
        <translation>%1 大小为 %2x%3 像素，或不是平面图像：只读取每边 1 到 16384 像素的图像。</translation>
    </message>
    <message>
        <source>drawn and visible</source>
        <translation>绘制且可见</translation>
    </message>
    <message>
        <source>drawn in vain</source>
        <translation>徒劳绘制</translation>
    </message>
    <message>
        <source>wrongly culled</source>
        <translation>误剔除</translation>
    </message>
    <message>
        <source>The mesh &quot;%1&quot; would fall into %2 parts; at most %3 can be objects. Split it by=clusters with more triangles each.</source>
        <translation>网格“%1”会分成 %2 块，而物体最多 %3 个。请用 by=clusters 并给每块更多三角形来拆分。</translation>
    </message>
    <message>
        <source>Splitting the mesh</source>
        <translation>正在拆分网格</translation>
    </message>
    <message>
        <source>&quot;%1&quot; in &quot;%2&quot; is neither an object&apos;s number nor a range. Hidden objects are written as in 3,7-9.</source>
        <translation>“%2”中的“%1”既不是物体编号也不是范围。要隐藏的物体写成 3,7-9 的样子。</translation>
    </message>
    <message>
        <source>There is no object %1 to hide: the scene has %2 objects, counted from 0.</source>
        <translation>没有可隐藏的物体 %1：场景有 %2 个物体，从 0 数起。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2 triangles, too many to be one mesh.</source>
        <translation>“%1”有 %2 个三角形，太多，不能成为一个网格。</translation>
    </message>
    <message>
        <source>split: by=%1 is unknown. Write by=components or by=clusters.</source>
        <translation>split：by=%1 未知。请写 by=components 或 by=clusters。</translation>
    </message>
    <message>
        <source>split: triangles is the size of clusters. Write by=clusters with it, or leave it out.</source>
        <translation>split：triangles 是簇的大小。请与 by=clusters 一起写，或去掉它。</translation>
    </message>
    <message>
        <source>mesh file, or a generator with its own parameters</source>
        <translation>网格文件，或带有自己参数的生成器</translation>
    </message>
    <message>
        <source>a mesh with every object split, so that there are objects to leave out; draws the same picture</source>
        <translation>把每个物体拆开的网格，使得有物体可以剔除；画面不变</translation>
    </message>
    <message>
        <source>components: what hangs together becomes an object; clusters: compact pieces of like size do</source>
        <translation>components：相连的部分各成一个物体；clusters：大小相近的紧凑块各成一个物体</translation>
    </message>
    <message>
        <source>how many triangles a cluster has at most (with by=clusters)</source>
        <translation>一个簇最多有多少三角形（用 by=clusters 时）</translation>
    </message>
    <message>
        <source>%1: %2 is given twice.</source>
        <translation>%1：%2 给了两次。</translation>
    </message>
    <message>
        <source>The scene would fall into %1 objects; at most %2 are possible. Split it by=clusters with more triangles each.</source>
        <translation>场景会分成 %1 个物体，而最多 %2 个。请用 by=clusters 并给每块更多三角形来拆分。</translation>
    </message>
    <message>
        <source>left plane</source>
        <translation>左平面</translation>
    </message>
    <message>
        <source>right plane</source>
        <translation>右平面</translation>
    </message>
    <message>
        <source>bottom plane</source>
        <translation>下平面</translation>
    </message>
    <message>
        <source>top plane</source>
        <translation>上平面</translation>
    </message>
    <message>
        <source>near plane</source>
        <translation>近平面</translation>
    </message>
    <message>
        <source>far plane</source>
        <translation>远平面</translation>
    </message>
    <message>
        <source>Tested against the %1: even the nearest point of the bounds lies %2 outside, more than the bound of %3.</source>
        <translation>针对%1的测试：包围体的最近点也在外侧 %2 处，超过界限 %3。</translation>
    </message>
    <message>
        <source>The strategy leaves the object out: %1.</source>
        <translation>策略剔除该物体：%1。</translation>
    </message>
    <message>
        <source>The strategy keeps the object.</source>
        <translation>策略保留该物体。</translation>
    </message>
    <message>
        <source>The object &quot;%1&quot; is tested as one box with %2 triangles.</source>
        <translation>物体“%1”作为一个包含 %2 个三角形的包围盒进行测试。</translation>
    </message>
    <message>
        <source>OpenGL draws the triangle: both sides count.</source>
        <translation>OpenGL 绘制该三角形：双面都算。</translation>
    </message>
    <message>
        <source>OpenGL drops the triangle: it is back-facing.</source>
        <translation>OpenGL 丢弃该三角形：它是背面。</translation>
    </message>
    <message>
        <source>OpenGL draws the triangle: its front is turned to the eye.</source>
        <translation>OpenGL 绘制该三角形：其正面朝向视点。</translation>
    </message>
    <message>
        <source>The triangle is given to OpenGL.</source>
        <translation>该三角形被提交给 OpenGL。</translation>
    </message>
    <message>
        <source>The triangle is not given to OpenGL.</source>
        <translation>该三角形未被提交给 OpenGL。</translation>
    </message>
    <message>
        <source>OpenGL lost its context (the graphics driver was reset), which ended the experiment. What was measured before is kept; start it again for the rest.</source>
        <translation>OpenGL 上下文丢失（显卡驱动被重置），实验因此结束。此前的测量结果已保留；如需其余部分，请重新开始。</translation>
    </message>
    <message>
        <source>OpenGL lost its context (the graphics driver was reset). The scene is being uploaded again; nothing is lost.</source>
        <translation>OpenGL 上下文丢失（显卡驱动被重置）。正在重新上传场景；没有任何丢失。</translation>
    </message>
    <message>
        <source>OpenGL lost its context, and no new one can be made. What is shown stays: save the session and start Cullscope again.</source>
        <translation>OpenGL 上下文丢失，且无法创建新的。已显示的内容保持不变：请保存会话并重新启动 Cullscope。</translation>
    </message>
    <message>
        <source>OpenGL lost its context while this picture was drawn. Take the picture again.</source>
        <translation>绘制此图时 OpenGL 上下文丢失。请重新截图。</translation>
    </message>
    <message>
        <source>The field of view changed while the path was recorded: all of it has that of its first pose.</source>
        <translation>录制路径时视场角发生了变化：整条路径都采用第一个姿态的视场角。</translation>
    </message>
    <message>
        <source>centroid map</source>
        <translation>质心图</translation>
    </message>
    <message>
        <source>triangle index map</source>
        <translation>三角形索引图</translation>
    </message>
    <message>
        <source>The triangle index map of %1 would have more than %2 entries: choose a lower resolution.</source>
        <translation>%1 的三角形索引图将超过 %2 个条目：请选择较低的分辨率。</translation>
    </message>
    <message>
        <source>%1 was repaired. Dropped faces: degenerate %2, duplicate %3, out of range %4; vertices that are no numbers: %5; other remarks: %6. The Scene panel tells all.</source>
        <translation>%1 已修复。丢弃的面：退化 %2，重复 %3，超出范围 %4；不是数字的顶点：%5；其他说明：%6。详情见场景面板。</translation>
    </message>
    <message>
        <source>%1 cannot be written: pictures of plots are SVG, PDF or PNG. Give the name one of the endings .svg, .pdf and .png.</source>
        <translation>无法写入 %1：图表图片的格式为 SVG、PDF 或 PNG。请使用扩展名 .svg、.pdf 或 .png。</translation>
    </message>
    <message>
        <source>Another experiment is under way: let it end, or cancel it.</source>
        <translation>另一个实验正在进行：请等它结束，或取消它。</translation>
    </message>
    <message>
        <source>The graphics memory does not hold this strategy&apos;s order of the triangles (%1 bytes): use client vertex arrays or a smaller scene.</source>
        <translation>显存容不下该策略的三角形次序（%1 字节）：请使用客户端顶点数组或更小的场景。</translation>
    </message>
    <message>
        <source>The numbers of the triangles in this strategy&apos;s order need %1 bytes in one buffer and this OpenGL gives %2: choose a strategy that keeps the mesh&apos;s order, or a part of the scene.</source>
        <translation>按该策略次序的三角形编号在一个缓冲区中需要 %1 字节，而此 OpenGL 只提供 %2：请选择保持网格次序的策略，或场景的一部分。</translation>
    </message>
    <message>
        <source>The paper&apos;s text has 144,046 faces, its Table 2 has 144,078: 144,046 are measured here, by subdividing the bunny that is installed.</source>
        <translation>论文正文写 144,046 个面，表 2 写 144,078 个：这里把已安装的兔子细分为 144,046 个面来测量。</translation>
    </message>
    <message>
        <source>The paper compares with drawing every face, back faces too. Against OpenGL&apos;s own back-face culling the gain is smaller: both ratios are given.</source>
        <translation>论文与绘制所有面（包括背面）相比较。与 OpenGL 自身的背面剔除相比，收益较小：两个比值都给出。</translation>
    </message>
    <message>
        <source>The paper counts no lost pixels; here every picture is compared with the exact one.</source>
        <translation>论文没有统计丢失的像素；这里每幅图像都与精确图像比较。</translation>
    </message>
    <message>
        <source>The paper&apos;s machine was a Xeon at 2.33 GHz with a Quadro FX 5500: compare the ratios, not the frames per second.</source>
        <translation>论文所用机器为 2.33 GHz 的 Xeon 和 Quadro FX 5500：请比较比值，而不是每秒帧数。</translation>
    </message>
    <message>
        <source>Four windows of 320 × 240 are in Table 3 and in Table 4, with different numbers: 376, 421, 202 against 206, 286, 161 frames per second.</source>
        <translation>四个 320 × 240 的窗口同时出现在表 3 和表 4 中，但数字不同：每秒 376、421、202 帧对 206、286、161 帧。</translation>
    </message>
    <message>
        <source>model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>memory access map</source>
        <translation>内存访问图</translation>
    </message>
    <message>
        <source>the three maps</source>
        <translation>三张图合计</translation>
    </message>
    <message>
        <source>Sizes of the three structures</source>
        <translation>三种结构的大小</translation>
    </message>
    <message>
        <source>The paper&apos;s formulas (4 floats a face; 2 floats a cell and face; 4 integers a cell) do not give its sizes: its index map would take 74.7 GB.</source>
        <translation>论文的公式（每个面 4 个浮点数；每个格子和面 2 个浮点数；每个格子 4 个整数）得不出它给的大小：索引图会占 74.7 GB。</translation>
    </message>
    <message>
        <source>In the paper&apos;s table the contents stand in the wrong columns: count, start and reference belong to the memory access map.</source>
        <translation>论文的表中内容放错了列：个数、起点和引用属于内存访问图。</translation>
    </message>
    <message>
        <source>All at 360 × 180 cells; 1 MB is 1,000,000 bytes.</source>
        <translation>均为 360 × 180 个格子；1 MB 为 1,000,000 字节。</translation>
    </message>
    <message>
        <source>structure</source>
        <translation>结构</translation>
    </message>
    <message>
        <source>paper: MB</source>
        <translation>论文：MB</translation>
    </message>
    <message>
        <source>paper&apos;s formula: MB</source>
        <translation>论文公式：MB</translation>
    </message>
    <message>
        <source>here: MB</source>
        <translation>此处：MB</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>字节</translation>
    </message>
    <message>
        <source>build, ms</source>
        <translation>构建，ms</translation>
    </message>
    <message>
        <source>strategy</source>
        <translation>策略</translation>
    </message>
    <message>
        <source>faces</source>
        <translation>面</translation>
    </message>
    <message>
        <source>in frustum</source>
        <translation>视锥内</translation>
    </message>
    <message>
        <source>cases found</source>
        <translation>判定的情形</translation>
    </message>
    <message>
        <source>views</source>
        <translation>视点</translation>
    </message>
    <message>
        <source>fps max</source>
        <translation>fps 最大</translation>
    </message>
    <message>
        <source>fps min</source>
        <translation>fps 最小</translation>
    </message>
    <message>
        <source>fps mean</source>
        <translation>fps 平均</translation>
    </message>
    <message>
        <source>× all [95 %]</source>
        <translation>× all [95 %]</translation>
    </message>
    <message>
        <source>× backface [95 %]</source>
        <translation>× backface [95 %]</translation>
    </message>
    <message>
        <source>missed px</source>
        <translation>丢失像素</translation>
    </message>
    <message>
        <source>missed ppm</source>
        <translation>丢失 ppm</translation>
    </message>
    <message>
        <source>largest hole, px</source>
        <translation>最大空洞，像素</translation>
    </message>
    <message>
        <source>paper: fps</source>
        <translation>论文：fps</translation>
    </message>
    <message>
        <source>paper: × all</source>
        <translation>论文：× all</translation>
    </message>
    <message>
        <source>case</source>
        <translation>情形</translation>
    </message>
    <message>
        <source>One window of 320 × 240, the object cut by the frustum</source>
        <translation>一个 320 × 240 的窗口，视锥切过物体</translation>
    </message>
    <message>
        <source>paper: faces</source>
        <translation>论文：面</translation>
    </message>
    <message>
        <source>Four windows, of two sizes</source>
        <translation>四个窗口，两种大小</translation>
    </message>
    <message>
        <source>size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Four and eight windows of 320 × 240</source>
        <translation>四个和八个 320 × 240 的窗口</translation>
    </message>
    <message>
        <source>windows</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>One window of 640 × 480, the object inside the frustum</source>
        <translation>一个 640 × 480 的窗口，物体在视锥内</translation>
    </message>
    <message>
        <source>upload</source>
        <translation>上传方式</translation>
    </message>
    <message>
        <source>paper: fps max</source>
        <translation>论文：fps 最大</translation>
    </message>
    <message>
        <source>paper: fps min</source>
        <translation>论文：fps 最小</translation>
    </message>
    <message>
        <source>paper: fps mean</source>
        <translation>论文：fps 平均</translation>
    </message>
    <message>
        <source>The paper has &quot;10 or more&quot; views and does not say which: here 12, evenly around the object at three radii, all of it in view. spherical-horizon is not the paper&apos;s: it is the same idea made right.</source>
        <translation>论文只说视点“10 个以上”，没有说明是哪些：这里为 12 个，在三倍半径处均匀环绕物体，物体全部可见。spherical-horizon 不是论文的方法，而是同一思想的正确做法。</translation>
    </message>
    <message>
        <source>There is no colouring of the index map &quot;%1&quot;. Known: %2.</source>
        <translation>没有索引图着色方式“%1”。已有：%2。</translation>
    </message>
    <message>
        <source>There is no experiment &quot;%1&quot;. Known: %2.</source>
        <translation>没有实验“%1”。已知：%2。</translation>
    </message>
    <message>
        <source>12 close views with a pole of the spherical map in them, 9.4 % of the faces in the frustum</source>
        <translation>12 个近景，球面图的一极在其中，9.4 % 的面在视锥体内</translation>
    </message>
    <message>
        <source>12 close views of one clump of the spherical map, 11.4 % of the faces in the frustum</source>
        <translation>12 个近景，球面图上为一整块，11.4 % 的面在视锥体内</translation>
    </message>
    <message>
        <source>12 close views of a clump that the map&apos;s seam splits, 18.3 % of the faces in the frustum</source>
        <translation>12 个近景，球面图上的一块被接缝分开，18.3 % 的面在视锥体内</translation>
    </message>
    <message>
        <source>Width of a contour band, seen from the centre.</source>
        <translation>从中心看等高环带的宽度。</translation>
    </message>
    <message>
        <source>Sectors into which a contour band is divided.</source>
        <translation>等高环带所分的扇区数。</translation>
    </message>
    <message>
        <source>draw list</source>
        <translation>绘制列表</translation>
    </message>
    <message>
        <source>maps and bands</source>
        <translation>图与等高环带</translation>
    </message>
    <message>
        <source>Spherical coordinates</source>
        <translation>球坐标</translation>
    </message>
    <message>
        <source>Looks up on a map of directions what four corner rays enclose; seen whole, compares contour bands by S. As published, with its losses.</source>
        <translation>在方向图上查找四条角光线所围的部分；整体可见时按 S 比较等高环带。与论文一致，损失也一并保留。</translation>
    </message>
    <message>
        <source>straight on the map, so that the extremes are the hits&apos;</source>
        <translation>在图上连直线，极值即交点的极值</translation>
    </message>
    <message>
        <source>by great circles, whose extremes may lie between the hits</source>
        <translation>沿大圆相连，极值可能在交点之间</translation>
    </message>
    <message>
        <source>Spherical coordinates, exact horizon</source>
        <translation>球坐标，精确地平线</translation>
    </message>
    <message>
        <source>Leaves out cells whose slope lies below the horizon of the surface in front of them: loses nothing of star-shaped objects.</source>
        <translation>省去斜率低于其前方表面地平线的单元：对星形物体没有任何损失。</translation>
    </message>
    <message>
        <source>cut by the frustum</source>
        <translation>被视锥体切割</translation>
    </message>
    <message>
        <source>inside the frustum</source>
        <translation>在视锥体内</translation>
    </message>
    <message>
        <source>around the eye</source>
        <translation>包围视点</translation>
    </message>
    <message>
        <source>The strategy draws the object in part; the rest is left out: %1.</source>
        <translation>该策略绘制物体的一部分；其余省去：%1。</translation>
    </message>
    <message>
        <source>The object &quot;%1&quot; is tested as one bounding sphere with %2 triangles.</source>
        <translation>物体“%1”作为一个含 %2 个三角形的包围球来检验。</translation>
    </message>
    <message>
        <source>Its centroid lies in the map&apos;s row %1, column %2: zenith angle %3° to %4°, azimuth %5° to %6°.</source>
        <translation>其重心在图的第 %1 行第 %2 列：天顶角 %3° 至 %4°，方位角 %5° 至 %6°。</translation>
    </message>
    <message>
        <source>The cell lies in the visible region&apos;s boxes (case %1).</source>
        <translation>单元在可见区域的盒内（情形 %1）。</translation>
    </message>
    <message>
        <source>The cell lies outside the visible region&apos;s boxes (case %1).</source>
        <translation>单元在可见区域的盒外（情形 %1）。</translation>
    </message>
    <message>
        <source>The object&apos;s bounding sphere: %1.</source>
        <translation>物体的包围球：%1。</translation>
    </message>
    <message>
        <source>half a hollow sphere, open towards z: closed, hides its inside from its outside</source>
        <translation>半个空心球，朝 z 开口：封闭，内侧被外侧遮住</translation>
    </message>
    <message>
        <source>Rows of the maps, 2 at least; columns are twice as many. A mesh has no more cells than triangles. 0: as many cells a triangle as in the paper.</source>
        <translation>图的行数，至少 2；列数为其两倍。网格的单元不多于三角形。0：每个三角形的单元数与论文相同。</translation>
    </message>
    <message>
        <source>order of the triangles</source>
        <translation>三角形的顺序</translation>
    </message>
    <message>
        <source>bounds of the cells</source>
        <translation>单元的边界</translation>
    </message>
    <message>
        <source>There is no layout of the map &quot;%1&quot;. Known: %2.</source>
        <translation>没有名为“%1”的图布局。可用：%2。</translation>
    </message>
    <message>
        <source>filled</source>
        <translation>已填充</translation>
    </message>
    <message>
        <source>the mesh is not closed or not consistently oriented</source>
        <translation>网格不封闭，或朝向不一致</translation>
    </message>
    <message>
        <source>the centre of the bounding sphere lies outside the solid</source>
        <translation>包围球的中心位于实体之外</translation>
    </message>
    <message>
        <source>the surface comes too near to the centre of the bounding sphere</source>
        <translation>表面离包围球的中心太近</translation>
    </message>
    <message>
        <source>meshes of more than five million triangles are not asked whether they are closed</source>
        <translation>超过五百万个三角形的网格不检查是否封闭</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>单元</translation>
    </message>
    <message>
        <source>cells against the frustum</source>
        <translation>单元与视锥体的测试</translation>
    </message>
    <message>
        <source>normal cones</source>
        <translation>法线锥</translation>
    </message>
    <message>
        <source>horizon of the kernel</source>
        <translation>内核的地平线</translation>
    </message>
    <message>
        <source>groups of objects</source>
        <translation>物体组</translation>
    </message>
    <message>
        <source>Spherical coordinates, lossless</source>
        <translation>球坐标，无损</translation>
    </message>
    <message>
        <source>Tests the cells of a map of directions, from large to small, against the frustum, by normal cones and by the horizon of the solid&apos;s inner kernel: loses nothing on any mesh.</source>
        <translation>由大到小测试方向图的单元：与视锥体比较，用法线锥，并用实体内核的地平线；在任何网格上都不丢失内容。</translation>
    </message>
    <message>
        <source>How directions are laid out on the map.</source>
        <translation>方向在图上的布局方式。</translation>
    </message>
    <message>
        <source>an octahedron unfolded: no poles, no trigonometry</source>
        <translation>展开的八面体：没有极点，没有三角函数</translation>
    </message>
    <message>
        <source>rows of zenith angle and columns of azimuth, as in the paper</source>
        <translation>如论文所述，以天顶角为行、方位角为列</translation>
    </message>
    <message>
        <source>How often the map is quartered: 2^level cells a side; 0: down to some four dozen triangles a cell. An object of fewer than a thousand is one cell.</source>
        <translation>图被四等分的次数：每边 2^level 个单元；0：细分到每个单元约四十八个三角形。不足一千个三角形的物体为一个单元。</translation>
    </message>
    <message>
        <source>Whether cells whose triangles all face away are left out (where only front sides are drawn).</source>
        <translation>是否剔除所有三角形都背向的单元（仅绘制正面时）。</translation>
    </message>
    <message>
        <source>Whether cells behind the solid&apos;s inner kernel are left out (where the mesh is closed).</source>
        <translation>是否剔除实体内核之后的单元（网格封闭时）。</translation>
    </message>
    <message>
        <source>It lies in a group of %1 objects, whose box was tested first: it reaches over the edge of the frustum, so that its objects were tested one by one.</source>
        <translation>它属于一个有 %1 个物体的组，先测试了该组的包围盒：跨越视锥体的边界，因此对其中的物体逐一测试。</translation>
    </message>
    <message>
        <source>It lies in a group of %1 objects, whose box was tested first: outside the %2.</source>
        <translation>它属于一个有 %1 个物体的组，先测试了该组的包围盒：位于%2之外。</translation>
    </message>
    <message>
        <source>It lies in a group of %1 objects, whose box was tested first: wholly inside the frustum, so that nothing of it was tested again.</source>
        <translation>它属于一个有 %1 个物体的组，先测试了该组的包围盒：完全位于视锥体之内，因此组内不再逐一测试。</translation>
    </message>
    <message>
        <source>No test left the cell out: its triangles are drawn.</source>
        <translation>没有测试剔除该单元：绘制其三角形。</translation>
    </message>
    <message>
        <source>All normals of the cell lie in a cone that is turned away from the eye, by more than the picture&apos;s snapping could undo.</source>
        <translation>该单元的所有法线都位于背向视点的锥内，其程度超过图像取整所能改变的范围。</translation>
    </message>
    <message>
        <source>All sight lines to the cell pass through the solid&apos;s inner kernel first.</source>
        <translation>到该单元的所有视线都先穿过实体的内核。</translation>
    </message>
    <message>
        <source>The box around the cell&apos;s triangles lies outside one plane of the frustum.</source>
        <translation>该单元三角形的包围盒位于视锥体某一平面之外。</translation>
    </message>
    <message>
        <source>The kernel&apos;s horizon is not used: %1.</source>
        <translation>未使用内核的地平线：%1。</translation>
    </message>
    <message>
        <source>The object has too few triangles to be divided: it is one cell.</source>
        <translation>该物体的三角形太少，不再划分：它是一个单元。</translation>
    </message>
    <message>
        <source>The walk over the map ended at a cell of level %1, which holds %2 triangles.</source>
        <translation>对图的遍历止于层级 %1 的单元，其中有 %2 个三角形。</translation>
    </message>
    <message>
        <source>The strategy draws the object in part; %1 of its triangles are left out: %2.</source>
        <translation>策略绘制该物体的一部分；其中 %1 个三角形被剔除：%2。</translation>
    </message>
    <message>
        <source>OpenGL&apos;s selection mode was removed from the core profile, and this OpenGL gives no compatibility profile: ask by occlusion queries.</source>
        <translation>OpenGL 的选择模式已从核心配置文件中移除，而此 OpenGL 不提供兼容配置文件：请改用遮挡查询。</translation>
    </message>
    <message>
        <source>The paper does not give its 40 viewpoints: here a walk on which the frustum leaves out about as much, 79 % on average.</source>
        <translation>论文未给出其 40 个视点：这里走的是一条视锥体剔除比例相近的路径，平均 79 %。</translation>
    </message>
    <message>
        <source>Two-sided rows (solid lines) draw both sides of every face, as the paper does: compare them with all. Front rows (dashed) leave back faces to OpenGL: compare them with backface.</source>
        <translation>双面的行（实线）与论文一样绘制每个面的两侧，应与 all 比较；正面的行（虚线）把背面留给 OpenGL，应与 backface 比较。</translation>
    </message>
    <message>
        <source>The paper&apos;s method is frustum-select; frustum tests the same boxes on the processor. The paper&apos;s largest speed-up is its 33 fps over its 0.83.</source>
        <translation>论文的方法是 frustum-select；frustum 在处理器上测试同样的包围盒。论文的最大加速比为 33 fps 除以 0.83。</translation>
    </message>
    <message>
        <source>Culling saves work on triangles, not on pixels: where pixels take much of the frame, as in a software OpenGL, the gain is small.</source>
        <translation>剔除节省的是三角形的工作，而不是像素的工作：当像素占帧时间的大部分时（如软件 OpenGL），收益较小。</translation>
    </message>
    <message>
        <source>Where the walk leads through a bunny, a picture of both sides shows its inside, which backface does not draw: those are its missed pixels.</source>
        <translation>路径穿过兔子时，双面的图像会显示其内侧，而 backface 不绘制它：这就是它丢失的像素。</translation>
    </message>
    <message>
        <source>The paper&apos;s machine was a Pentium III at 866 MHz with a GeForce3 Ti 200: compare the ratios, not the frames per second. The paper counts no lost pixels.</source>
        <translation>论文的机器是 866 MHz 的 Pentium III 和 GeForce3 Ti 200：请比较比值，而不是每秒帧数。论文没有统计丢失的像素。</translation>
    </message>
    <message>
        <source>sides drawn</source>
        <translation>绘制的面</translation>
    </message>
    <message>
        <source>fps, all views</source>
        <translation>fps，全部视点</translation>
    </message>
    <message>
        <source>paper: × all, max</source>
        <translation>论文：× all，最大</translation>
    </message>
    <message>
        <source>× all, best view [95 %]</source>
        <translation>× all，最大的视点 [95 %]</translation>
    </message>
    <message>
        <source>paper: culled, %</source>
        <translation>论文：剔除，%</translation>
    </message>
    <message>
        <source>culled, %</source>
        <translation>剔除，%</translation>
    </message>
    <message>
        <source>culled max, %</source>
        <translation>最大剔除，%</translation>
    </message>
    <message>
        <source>paper: culling, % of the frame</source>
        <translation>论文：剔除耗时，占帧 %</translation>
    </message>
    <message>
        <source>culling, % of the frame</source>
        <translation>剔除耗时，占帧 %</translation>
    </message>
    <message>
        <source>Frames per second by viewpoint</source>
        <translation>各视点的每秒帧数</translation>
    </message>
    <message>
        <source>viewpoint</source>
        <translation>视点</translation>
    </message>
    <message>
        <source>frames per second</source>
        <translation>每秒帧数</translation>
    </message>
    <message>
        <source>paper, culled, at most:</source>
        <translation>论文，剔除，最高：</translation>
    </message>
    <message>
        <source>paper, culled, mean:</source>
        <translation>论文，剔除，平均：</translation>
    </message>
    <message>
        <source>paper, every bunny drawn:</source>
        <translation>论文，全部绘制：</translation>
    </message>
    <message>
        <source>400 bunnies from 40 viewpoints: view-frustum culling</source>
        <translation>从 40 个视点看 400 只兔子：视锥体剔除</translation>
    </message>
    <message>
        <source>front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>two-sided</source>
        <translation>双面</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not of the form key=value.</source>
        <translation>“%1”不是 key=value 的形式。</translation>
    </message>
    <message>
        <source>The strategy &quot;%1&quot; has no parameters.</source>
        <translation>策略“%1”没有参数。</translation>
    </message>
    <message>
        <source>boxes</source>
        <translation>盒</translation>
    </message>
    <message>
        <source>asking OpenGL</source>
        <translation>询问 OpenGL</translation>
    </message>
    <message>
        <source>View-frustum culling by selection</source>
        <translation>选择模式视锥体剔除</translation>
    </message>
    <message>
        <source>Draws the objects&apos; boxes in OpenGL&apos;s selection mode: the hit records name the objects in view.</source>
        <translation>以 OpenGL 选择模式绘制物体的盒：命中记录给出视野内的物体。</translation>
    </message>
    <message>
        <source>Words of the hit buffer to begin with, four an object in view: one that overflows is doubled, and the boxes are drawn again.</source>
        <translation>命中缓冲区的初始字数（视野内每个对象四个）：溢出时加倍，并重新绘制各盒。</translation>
    </message>
    <message>
        <source>View-frustum culling by queries</source>
        <translation>查询式视锥体剔除</translation>
    </message>
    <message>
        <source>Draws the objects&apos; boxes unseen, with an occlusion query each: those that cover a sample are in view.</source>
        <translation>不可见地绘制物体的盒，每个盒一次遮挡查询：覆盖采样点的即在视野内。</translation>
    </message>
    <message>
        <source>the mesh&apos;s own box, turned with the object, by its corner farthest inside</source>
        <translation>网格自身的盒随物体旋转，以其最靠内的角点判断</translation>
    </message>
    <message>
        <source>View-frustum culling by groups</source>
        <translation>分组视锥体剔除</translation>
    </message>
    <message>
        <source>Leaves out whole groups of objects by an octree over their boxes, and draws the rest nearest first.</source>
        <translation>用物体盒的八叉树整组剔除，其余由近及远绘制。</translation>
    </message>
    <message>
        <source>Whether what several planes cut is tested by separating axes too, which leaves out what lies beside the frustum&apos;s edges.</source>
        <translation>是否对被多个平面切割者再用分离轴测试，从而剔除位于视锥体棱边旁的物体。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; draws in OpenGL&apos;s selection mode, which was removed from the core profile, and this OpenGL (%2) gives no compatibility profile: &quot;frustum-query&quot; asks the same without it.</source>
        <translation>“%1”使用 OpenGL 的选择模式，该模式已从核心配置文件中移除，而此 OpenGL（%2）不提供兼容配置文件：“frustum-query”无需它即可作同样的询问。</translation>
    </message>
    <message>
        <source>This strategy asks OpenGL what is visible, and there is no OpenGL context here.</source>
        <translation>此策略要向 OpenGL 询问可见内容，而这里没有 OpenGL 上下文。</translation>
    </message>
    <message>
        <source>No single plane has the bounds outside, but an axis parts them from the frustum: they lie beside one of its edges or corners.</source>
        <translation>没有单个平面使包围体全在外侧，但有一根轴将其与视锥体分开：它位于视锥体的某条棱或某个角旁。</translation>
    </message>
    <message>
        <source>The box reaches the near rectangle of the view: it is visible without asking.</source>
        <translation>盒触及视图的近平面矩形：无需询问即视为可见。</translation>
    </message>
    <message>
        <source>OpenGL was asked about the box, grown by %1: nothing of it was hit.</source>
        <translation>就扩大 %1 的盒询问了 OpenGL：未命中任何部分。</translation>
    </message>
    <message>
        <source>OpenGL was asked about the box, grown by %1: it was hit.</source>
        <translation>就扩大 %1 的盒询问了 OpenGL：已命中。</translation>
    </message>
    <message>
        <source>It lies in a group of %1 objects, whose box was tested first: an axis parts it from the frustum.</source>
        <translation>它属于一个 %1 个物体的组，该组的盒先被测试：有一根轴将其与视锥体分开。</translation>
    </message>
    <message>
        <source>Tested against the %1: all of the bounds lie inside, the farthest point by %2.</source>
        <translation>针对%1的测试：整个包围体都在内侧，最深的点在内侧 %2 处。</translation>
    </message>
    <message>
        <source>Tested against the %1: the bounds lie %2 outside, within the bound of %3, and count as inside.</source>
        <translation>针对%1的测试：包围体在外侧 %2 处，但未超过界限 %3，视为内侧。</translation>
    </message>
    <message>
        <source>Tested against the %1: the bounds reach %2 to the inside.</source>
        <translation>针对%1的测试：包围体伸入内侧 %2。</translation>
    </message>
    <message>
        <source>Contour bands</source>
        <translation>等高环带</translation>
    </message>
    <message>
        <source>Inner kernel and horizon</source>
        <translation>内核与地平线</translation>
    </message>
    <message>
        <source>&amp;Contour bands</source>
        <translation>等高环带(&amp;C)</translation>
    </message>
    <message>
        <source>Inner &amp;kernel and horizon</source>
        <translation>内核与地平线(&amp;K)</translation>
    </message>
    <message>
        <source>Show the solid&apos;s inner kernel in the active view, and its outline as the culling camera sees it: what lies behind it is left out by the lossless spherical strategy</source>
        <translation>在活动视图中显示实体的内核及剔除相机所见的轮廓：其后的内容会被无损球坐标策略剔除</translation>
    </message>
    <message>
        <source>A strategy made a picture of %1 × %2 pixels for a view of %3 × %4.</source>
        <translation>策略为 %3 × %4 的视图生成了 %1 × %2 像素的图像。</translation>
    </message>
    <message>
        <source>Tested by separating axes, for several planes cut the bounds: none parts them from the frustum.</source>
        <translation>有多个平面切过包围体，因此再用分离轴测试：没有轴能把它与视锥分开。</translation>
    </message>
    <message>
        <source>A few views with little in them raise the means of the frames per second and of the views&apos; ratios; &quot;fps, all views&quot; and &quot;× all&quot; are of the total times.</source>
        <translation>少数内容很少的视点会抬高每秒帧数和各视点比值的平均值；“fps，全部视点”和“× all”按总时间计算。</translation>
    </message>
    <message>
        <source>mean of the views&apos; × all [95 %]</source>
        <translation>各视点 × all 的平均值 [95 %]</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Speed against loss</source>
        <translation>速度与损失</translation>
    </message>
    <message>
        <source>missed pixels, share</source>
        <translation>丢失像素的比例</translation>
    </message>
    <message>
        <source>for each object</source>
        <translation>对每个物体</translation>
    </message>
    <message>
        <source>box at near rectangle: in view</source>
        <translation>盒触及近矩形：可见</translation>
    </message>
    <message>
        <source>outside near or far: not in view</source>
        <translation>在近平面之前或远平面之后：不可见</translation>
    </message>
    <message>
        <source>else in view if OpenGL hit it</source>
        <translation>否则 OpenGL 命中其盒则可见</translation>
    </message>
    <message>
        <source>in view: draw it</source>
        <translation>可见：绘制</translation>
    </message>
    <message>
        <source>not in view: leave it out</source>
        <translation>不可见：剔除</translation>
    </message>
    <message>
        <source>draw grown boxes for selection</source>
        <translation>在选择模式下绘制扩大的盒</translation>
    </message>
    <message>
        <source>draw grown boxes, a query each</source>
        <translation>不可见地绘制扩大的盒，各用一次查询</translation>
    </message>
    <message>
        <source>visit(group, planes that may cut it)</source>
        <translation>访问(组, 可能与其相交的平面)</translation>
    </message>
    <message>
        <source>test its box against these planes</source>
        <translation>用这些平面测试其盒</translation>
    </message>
    <message>
        <source>several cut it: test axes too</source>
        <translation>若与多个平面相交：寻找分离轴</translation>
    </message>
    <message>
        <source>outside: leave all its objects out</source>
        <translation>在外：剔除其全部物体</translation>
    </message>
    <message>
        <source>inside: keep all its objects</source>
        <translation>在所有平面之内：保留其全部物体</translation>
    </message>
    <message>
        <source>else visit(parts, cutting planes)</source>
        <translation>否则访问(各部分, 与其相交的平面)</translation>
    </message>
    <message>
        <source>no parts: test each object too</source>
        <translation>没有部分：同样测试每个物体</translation>
    </message>
    <message>
        <source>outside: leave the object out</source>
        <translation>在外：剔除该物体</translation>
    </message>
    <message>
        <source>draw the objects kept, nearest first</source>
        <translation>由近到远绘制保留的物体</translation>
    </message>
    <message>
        <source>Objects by the plane that rejected them</source>
        <translation>按排除它们的平面统计物体</translation>
    </message>
    <message>
        <source>no single plane</source>
        <translation>无单一平面</translation>
    </message>
    <message>
        <source>Size by contour band</source>
        <translation>各等高环带的大小</translation>
    </message>
    <message>
        <source>Beyond α = %1 nothing is drawn.</source>
        <translation>α = %1 之后不绘制任何内容。</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>斜率</translation>
    </message>
    <message>
        <source>S, mesh units</source>
        <translation>S，网格单位</translation>
    </message>
    <message>
        <source>Upwards: %1; to the right: angle α from the axis to the eye; sector %2</source>
        <translation>向上：%1；向右：与视点方向轴的夹角 α；扇区 %2</translation>
    </message>
    <message>
        <source>Upwards: %1, the largest of all sectors; to the right: angle α from the axis to the eye. Each sector is compared by itself; a band of two colours is drawn in some sectors and hidden in others.</source>
        <translation>向上：%1（所有扇区中的最大值）；向右：与视点方向轴的夹角 α。每个扇区单独比较；双色的环带在部分扇区中绘制，在其他扇区中被遮挡。</translation>
    </message>
    <message>
        <source>α %1 to %2</source>
        <translation>α %1 至 %2</translation>
    </message>
    <message>
        <source>drawn: %1 %2</source>
        <translation>已绘制：%1 %2</translation>
    </message>
    <message>
        <source>hidden: %1 %2</source>
        <translation>被遮挡：%1 %2</translation>
    </message>
    <message>
        <source>Nothing lies here.</source>
        <translation>此处没有内容。</translation>
    </message>
    <message>
        <source>largest nearer: %1</source>
        <translation>更近处的最大值：%1</translation>
    </message>
    <message>
        <source>drawn</source>
        <translation>已绘制</translation>
    </message>
    <message>
        <source>drawn in some sectors</source>
        <translation>在部分扇区绘制</translation>
    </message>
    <message>
        <source>hidden in some sectors</source>
        <translation>在部分扇区被遮挡</translation>
    </message>
    <message>
        <source>largest nearer</source>
        <translation>更近处的最大值</translation>
    </message>
    <message>
        <source>Se&amp;ctor:</source>
        <translation>扇区(&amp;C)：</translation>
    </message>
    <message>
        <source>Sectors divide the bands by the angle β about the axis to the eye; each one is tested by itself. Until you choose one, it is the one that is drawn farthest.</source>
        <translation>扇区按绕视点方向轴的角 β 划分环带，每个扇区单独测试。在您选择之前，显示绘制范围最远的扇区。</translation>
    </message>
    <message>
        <source>all</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>β %1 to %2</source>
        <translation>β %1 至 %2</translation>
    </message>
    <message>
        <source>%1 is %2: its bands are not tested. Bring all of it into the picture to see them.</source>
        <translation>%1：%2，未测试其环带。要查看环带，请让整个物体位于画面内。</translation>
    </message>
    <message>
        <source>Entries a cell</source>
        <translation>每单元条目数</translation>
    </message>
    <message>
        <source>triangles a cell, logarithmic</source>
        <translation>每单元三角形数，对数刻度</translation>
    </message>
    <message>
        <source>Farthest R</source>
        <translation>最远 R</translation>
    </message>
    <message>
        <source>farthest R, mesh units</source>
        <translation>最远 R，网格单位</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>层级</translation>
    </message>
    <message>
        <source>level where the walk ended</source>
        <translation>遍历结束的层级</translation>
    </message>
    <message>
        <source>Kernel</source>
        <translation>内核</translation>
    </message>
    <message>
        <source>R of the kernel, of the sphere&apos;s</source>
        <translation>内核的 R，占球半径的比例</translation>
    </message>
    <message>
        <source>Triangle index map</source>
        <translation>三角形索引图</translation>
    </message>
    <message>
        <source>Case 1: all azimuths, one range in all</source>
        <translation>情形 1：所有方位角，总共一个区间</translation>
    </message>
    <message>
        <source>Case 2: one clump, one range a row</source>
        <translation>情形 2：聚成一团，每行一个区间</translation>
    </message>
    <message>
        <source>Case 3: split by the seam, two ranges a row</source>
        <translation>情形 3：被接缝分开，每行两个区间</translation>
    </message>
    <message>
        <source>bottom left</source>
        <translation>左下</translation>
    </message>
    <message>
        <source>bottom right</source>
        <translation>右下</translation>
    </message>
    <message>
        <source>top right</source>
        <translation>右上</translation>
    </message>
    <message>
        <source>top left</source>
        <translation>左上</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>未使用</translation>
    </message>
    <message>
        <source>No kernel: the horizon is switched off, or the mesh is too small for one</source>
        <translation>没有内核：地平线已关闭，或网格太小</translation>
    </message>
    <message>
        <source>No kernel: %1</source>
        <translation>没有内核：%1</translation>
    </message>
    <message>
        <source>Kernel filled to R %1 at least</source>
        <translation>内核至少填充到 R %1</translation>
    </message>
    <message>
        <source>Horizon not used: the eye is inside the bounding sphere</source>
        <translation>未使用地平线：视点在包围球内</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1 (%2 of %3): %4</source>
        <translation>%1（第 %2 个，共 %3 个）：%4</translation>
    </message>
    <message>
        <source>Nothing of it is drawn.</source>
        <translation>完全不绘制。</translation>
    </message>
    <message>
        <source>Bands of %1; drawn: %2 of %3 triangles</source>
        <translation>环带宽 %1；已绘制三角形：%2 / %3</translation>
    </message>
    <message>
        <source>Everything of it is drawn.</source>
        <translation>全部绘制。</translation>
    </message>
    <message>
        <source>Drawn: %1 of %2 triangles</source>
        <translation>已绘制三角形：%1 / %2</translation>
    </message>
    <message>
        <source>Culled: frustum %1 · cones %2 · horizon %3</source>
        <translation>剔除：视锥体 %1 · 法线锥 %2 · 地平线 %3</translation>
    </message>
    <message>
        <source>Row %1, column %2</source>
        <translation>第 %1 行，第 %2 列</translation>
    </message>
    <message>
        <source>θ %1 to %2, φ %3 to %4</source>
        <translation>θ %1 至 %2，φ %3 至 %4</translation>
    </message>
    <message>
        <source>Triangles in it: %1, of which it owns %2</source>
        <translation>其中的三角形：%1，所属：%2</translation>
    </message>
    <message>
        <source>R %1 to %2 mesh units</source>
        <translation>R %1 至 %2 网格单位</translation>
    </message>
    <message>
        <source>Quadtree: level %1, triangles: %2, %3</source>
        <translation>四叉树：层级 %1，三角形：%2，%3</translation>
    </message>
    <message>
        <source>Corner ray %1, %2: confirmed on triangle %3.</source>
        <translation>角光线 %1，%2：已在三角形 %3 上确认相交。</translation>
    </message>
    <message>
        <source>Corner ray %1, %2: passes the object by; its place is where it enters the sphere.</source>
        <translation>角光线 %1，%2：从物体旁经过；取其进入包围球之处。</translation>
    </message>
    <message>
        <source>Corner ray %1, %2: misses the sphere; its place is the sphere&apos;s nearest point.</source>
        <translation>角光线 %1，%2：未命中包围球；取球上最近的点。</translation>
    </message>
    <message>
        <source>sector %1</source>
        <translation>扇区 %1</translation>
    </message>
    <message>
        <source>visible region</source>
        <translation>可见区域</translation>
    </message>
    <message>
        <source>corner: hit</source>
        <translation>角：命中</translation>
    </message>
    <message>
        <source>corner: miss, nearest point</source>
        <translation>角：未命中，最近点</translation>
    </message>
    <message>
        <source>contours of α every %1</source>
        <translation>α 的等高线，每 %1</translation>
    </message>
    <message>
        <source>nearest to the eye</source>
        <translation>离视点最近</translation>
    </message>
    <message>
        <source>opposite</source>
        <translation>对面</translation>
    </message>
    <message>
        <source>cell of the quadtree</source>
        <translation>四叉树单元</translation>
    </message>
    <message>
        <source>its sphere against six planes</source>
        <translation>用六个平面测试其球</translation>
    </message>
    <message>
        <source>outside: leave it out</source>
        <translation>在外：剔除</translation>
    </message>
    <message>
        <source>around the eye, flat: draw all</source>
        <translation>围住视点或扁平：全部绘制</translation>
    </message>
    <message>
        <source>cut by near, flat, small: draw all</source>
        <translation>与近平面相交、扁平或较小：全部绘制</translation>
    </message>
    <message>
        <source>else draw cells above the horizon</source>
        <translation>否则绘制高出前方地平线的单元</translation>
    </message>
    <message>
        <source>test groups, objects by planes</source>
        <translation>先组后物体，用平面测试</translation>
    </message>
    <message>
        <source>outside: leave it all out</source>
        <translation>在外：剔除该组或物体</translation>
    </message>
    <message>
        <source>each other object (small: draw)</source>
        <translation>对其余每个物体（较小者：绘制）</translation>
    </message>
    <message>
        <source>sphere outside: leave it out</source>
        <translation>其球在某平面之外：剔除</translation>
    </message>
    <message>
        <source>box outside: leave it out</source>
        <translation>其盒在某平面之外：剔除</translation>
    </message>
    <message>
        <source>faces away: leave it out</source>
        <translation>其法线全部背向：剔除</translation>
    </message>
    <message>
        <source>behind horizon: leave it out</source>
        <translation>在内核地平线之后：剔除</translation>
    </message>
    <message>
        <source>no test open, leaf, gap: draw</source>
        <translation>无待定测试、无部分或小间隙：绘制</translation>
    </message>
    <message>
        <source>Bands</source>
        <translation>环带</translation>
    </message>
    <message>
        <source>Triangles by the test that left them out</source>
        <translation>按剔除它们的测试统计三角形</translation>
    </message>
    <message>
        <source>planes of the frustum</source>
        <translation>视锥体的平面</translation>
    </message>
    <message>
        <source>distances</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>The object &quot;%1&quot; is tested as one sphere with %2 triangles.</source>
        <translation>物体“%1”作为一个包含 %2 个三角形的球进行测试。</translation>
    </message>
    <message>
        <source>Its sphere begins %1 from the eye, beyond the distance of %2: so far away it counts as too small.</source>
        <translation>其球始于离视点 %1 处，超出距离 %2：如此远则视为太小。</translation>
    </message>
    <message>
        <source>Its sphere begins %1 from the eye, within the distance of %2.</source>
        <translation>其球始于离视点 %1 处，在距离 %2 之内。</translation>
    </message>
    <message>
        <source>Draw distance</source>
        <translation>绘制距离</translation>
    </message>
    <message>
        <source>Draw &amp;distance</source>
        <translation>绘制距离(&amp;D)</translation>
    </message>
    <message>
        <source>Show in the active view how far from the culling eye objects are drawn</source>
        <translation>在活动视图中显示从剔除视点起绘制物体的最远距离</translation>
    </message>
    <message>
        <source>limit = distance × scene radius</source>
        <translation>界限 = 距离 × 场景球半径</translation>
    </message>
    <message>
        <source>d = distance of its sphere</source>
        <translation>d = 其球最近点的距离</translation>
    </message>
    <message>
        <source>if d &gt; limit: leave it out</source>
        <translation>若 d &gt; 界限：剔除</translation>
    </message>
    <message>
        <source>else draw it</source>
        <translation>否则绘制</translation>
    </message>
    <message>
        <source>How far from the eye objects are drawn, in radii of the scene&apos;s sphere.</source>
        <translation>从视点起绘制物体的最远距离，以场景球的半径为单位。</translation>
    </message>
    <message>
        <source>Leaves out objects that lie wholly beyond a distance from the eye.</source>
        <translation>剔除完全位于离视点一定距离之外的物体。</translation>
    </message>
    <message>
        <source>triangles to the raster</source>
        <translation>三角形到光栅</translation>
    </message>
    <message>
        <source>rasterising</source>
        <translation>光栅化</translation>
    </message>
    <message>
        <source>Of its %1 triangles %2 lie beyond a plane of the frustum and %3 are turned away: they are not drawn.</source>
        <translation>它的 %1 个三角形中，%2 个位于视锥体某一平面之外，%3 个背向：不予绘制。</translation>
    </message>
    <message>
        <source>depth comparisons</source>
        <translation>深度比较</translation>
    </message>
    <message>
        <source>samples written</source>
        <translation>写入的样本</translation>
    </message>
    <message>
        <source>pixels that show a surface</source>
        <translation>显示表面的像素</translation>
    </message>
    <message>
        <source>comparisons of a depth buffer</source>
        <translation>深度缓冲所需的比较</translation>
    </message>
    <message>
        <source>spans</source>
        <translation>扫描段</translation>
    </message>
    <message>
        <source>At column %1 a surface begins. Its depth %2 is compared with %3 of the one in front: it is nearer.</source>
        <translation>在第 %1 列有一个表面开始。其深度 %2 与最前表面的深度 %3 比较：它更近。</translation>
    </message>
    <message>
        <source>Whether parts of the picture are drawn on all processors at once; the picture is the same.</source>
        <translation>是否在所有处理器上同时绘制图像的各部分；图像相同。</translation>
    </message>
    <message>
        <source>Depth buffer, in software</source>
        <translation>深度缓冲（软件）</translation>
    </message>
    <message>
        <source>Draws every triangle on the processor and keeps the nearest surface at each sample.</source>
        <translation>在处理器上绘制每个三角形，并在每个样本处保留最近的表面。</translation>
    </message>
    <message>
        <source>clear all depths to the farthest</source>
        <translation>将所有深度清为最远</translation>
    </message>
    <message>
        <source>for each triangle, in any order</source>
        <translation>对每个三角形，顺序任意</translation>
    </message>
    <message>
        <source>transform, clip at the near plane</source>
        <translation>变换，按近平面裁剪</translation>
    </message>
    <message>
        <source>for each sample it covers</source>
        <translation>对它覆盖的每个样本</translation>
    </message>
    <message>
        <source>z = its depth there</source>
        <translation>z = 该处的深度</translation>
    </message>
    <message>
        <source>if z is nearer than the stored</source>
        <translation>若 z 比已存的更近</translation>
    </message>
    <message>
        <source>store z and the triangle</source>
        <translation>存入 z 和三角形</translation>
    </message>
    <message>
        <source>show what is stored</source>
        <translation>显示所存内容</translation>
    </message>
    <message>
        <source>Comparisons of depths</source>
        <translation>深度比较次数</translation>
    </message>
    <message>
        <source>Scan line, in software</source>
        <translation>扫描线（软件）</translation>
    </message>
    <message>
        <source>Draws row by row on the processor and compares depths only where surfaces begin, end or cross.</source>
        <translation>在处理器上逐行绘制，仅在表面开始、结束或相交之处比较深度。</translation>
    </message>
    <message>
        <source>edge table: edges by their first row</source>
        <translation>边表：按首行排列的边</translation>
    </message>
    <message>
        <source>for each row: its active edges</source>
        <translation>对每一行：其活动边</translation>
    </message>
    <message>
        <source>begins: compare with the front</source>
        <translation>开始：与最前者比较</translation>
    </message>
    <message>
        <source>front ends: compare the others</source>
        <translation>最前者结束：比较其余</translation>
    </message>
    <message>
        <source>two cross: compare, split the span</source>
        <translation>两者相交：比较，分开扫描段</translation>
    </message>
    <message>
        <source>fill the span, comparing nothing</source>
        <translation>不作比较，填充扫描段</translation>
    </message>
    <message>
        <source>the row is done</source>
        <translation>该行完成</translation>
    </message>
    <message>
        <source>show the rows</source>
        <translation>显示各行</translation>
    </message>
    <message>
        <source>stopped at the limit</source>
        <translation>达到上限而停止</translation>
    </message>
    <message>
        <source>BSP trees by the choice of the dividing plane</source>
        <translation>按分割平面的选法比较 BSP 树</translation>
    </message>
    <message>
        <source>&quot;random, small&quot;: 10,000 random triangles in a cube, with edges of at most a tenth of its side. &quot;random, large&quot;: with edges of up to its side, which fill it.</source>
        <translation>“random, small”：立方体内 10,000 个随机三角形，边长至多为其边长的十分之一。“random, large”：边长可达其边长，充满立方体。</translation>
    </message>
    <message>
        <source>A tree that needs more than 2,000,000 polygons is given up.</source>
        <translation>需要超过 2,000,000 个多边形的树会被放弃。</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>polygons</source>
        <translation>多边形</translation>
    </message>
    <message>
        <source>nodes</source>
        <translation>节点</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>tree</source>
        <translation>树</translation>
    </message>
    <message>
        <source>Computed from the scene of the same name: its planes P1, P2, … divide it level by level, and its objects hang at the leaves. C1 is the leaf behind all planes, the last one before all of them.</source>
        <translation>由同名场景计算：平面 P1、P2、… 逐层划分场景，物体挂在叶上。C1 是位于所有平面背面的叶，最后一个叶位于所有平面正面。</translation>
    </message>
    <message>
        <source>The order is that of drawing, back to front, as seen from the scene&apos;s camera V.</source>
        <translation>顺序是从场景的相机 V 看去由后向前的绘制顺序。</translation>
    </message>
    <message>
        <source>asked</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>answer key</source>
        <translation>答案</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>计算</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>不同</translation>
    </message>
    <message>
        <source>The lecture&apos;s quiz: leaves of a BSP tree and the order of drawing</source>
        <translation>课程测验：BSP 树的叶与绘制顺序</translation>
    </message>
    <message>
        <source>The lecture&apos;s worked example of a BSP tree</source>
        <translation>课程中的 BSP 树例题</translation>
    </message>
    <message>
        <source>The lecture&apos;s verdicts: very little depth overlap, painter&apos;s algorithm or BSP tree; little overlap, scan line; few surfaces, painter, BSP tree, scan line; many surfaces, depth buffer, octree; several views of a static scene, BSP tree. It gives no numbers: here 1 layer is very little overlap, 2 are little, 10 surfaces are few, 100,000 many.</source>
        <translation>讲义的结论：深度重叠极少时用画家算法或 BSP 树；重叠较少时用扫描线；面少时用画家算法、BSP 树、扫描线；面多时用深度缓冲、八叉树；从多个视点看静止场景时用 BSP 树。讲义没有给出数值：这里 1 层算极少重叠，2 层算较少，10 个面算少，100,000 个算多。</translation>
    </message>
    <message>
        <source>A verdict and the measurement agree where the method takes at most 1.25 times the least time of the first five methods, the structure built once and all views drawn.</source>
        <translation>构建一次结构并绘制所有视图后，若方法所用时间不超过前五种方法中最短时间的 1.25 倍，则结论与测量一致。</translation>
    </message>
    <message>
        <source>all and backface are the GPU&apos;s depth buffer, which the lecture says is used most; they are not among those that its verdicts compare. painter, bsp and octree-query draw with OpenGL, depth-buffer and scan-line on the processor.</source>
        <translation>all 和 backface 是 GPU 的深度缓冲，讲义说它用得最多；它们不在讲义结论所比较的方法之列。painter、bsp 和 octree-query 用 OpenGL 绘制，depth-buffer 和 scan-line 在处理器上绘制。</translation>
    </message>
    <message>
        <source>The scenes are layers with waves of height 0.02, so that their triangles lie in planes of their own and the layers do not meet: a BSP tree of flat layers would have a node a layer. With more layers than surfaces each has two triangles.</source>
        <translation>场景是波高 0.02 的各层，因此每个三角形有自己的平面，而各层互不相交：平坦的层在 BSP 树中每层只有一个节点。层数多于面数时，每层有两个三角形。</translation>
    </message>
    <message>
        <source>lecture: good for</source>
        <translation>讲义：适用于</translation>
    </message>
    <message>
        <source>all views, ms</source>
        <translation>所有视图，毫秒</translation>
    </message>
    <message>
        <source>both, ms</source>
        <translation>合计，毫秒</translation>
    </message>
    <message>
        <source>both ÷ least of five</source>
        <translation>合计 ÷ 五种中最小</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>结论</translation>
    </message>
    <message>
        <source>milliseconds, built and all views drawn</source>
        <translation>毫秒，构建并绘制所有视图</translation>
    </message>
    <message>
        <source>The lecture&apos;s methods by overlap, surfaces and views</source>
        <translation>讲义中的方法：按重叠、面数和视图数</translation>
    </message>
    <message>
        <source>layers</source>
        <translation>层</translation>
    </message>
    <message>
        <source>surfaces</source>
        <translation>面</translation>
    </message>
    <message>
        <source>method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Time by layers</source>
        <translation>按层数的时间</translation>
    </message>
    <message>
        <source>Time by surfaces</source>
        <translation>按面数的时间</translation>
    </message>
    <message>
        <source>Time by views of a static scene</source>
        <translation>按静止场景视图数的时间</translation>
    </message>
    <message>
        <source>A test</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>Drawn completely</source>
        <translation>全部绘制</translation>
    </message>
    <message>
        <source>Drawn in part</source>
        <translation>部分绘制</translation>
    </message>
    <message>
        <source>Left out completely</source>
        <translation>全部剔除</translation>
    </message>
    <message>
        <source>Drawn after all</source>
        <translation>最终仍绘制</translation>
    </message>
    <message>
        <source>About an object</source>
        <translation>关于物体</translation>
    </message>
    <message>
        <source>About a node</source>
        <translation>关于节点</translation>
    </message>
    <message>
        <source>About a cell</source>
        <translation>关于单元</translation>
    </message>
    <message>
        <source>About a ray</source>
        <translation>关于一条光线</translation>
    </message>
    <message>
        <source>About a band</source>
        <translation>关于一个带</translation>
    </message>
    <message>
        <source>About a part of a triangle</source>
        <translation>关于三角形的一部分</translation>
    </message>
    <message>
        <source>About a piece of a row</source>
        <translation>关于一行的一段</translation>
    </message>
    <message>
        <source>Triangles of the scene are drawn</source>
        <translation>绘制场景的三角形</translation>
    </message>
    <message>
        <source>Triangles of the strategy&apos;s own are drawn</source>
        <translation>绘制策略自己的三角形</translation>
    </message>
    <message>
        <source>A finished picture is shown</source>
        <translation>显示完成的图像</translation>
    </message>
    <message>
        <source>OpenGL is asked about boxes</source>
        <translation>就包围盒询问 OpenGL</translation>
    </message>
    <message>
        <source>Left out: %1</source>
        <translation>剔除：%1</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>第 %1 行</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>第 %1 行：%2</translation>
    </message>
    <message>
        <source>Drawn in part; the rest is left out: %1</source>
        <translation>绘制一部分，其余剔除：%1</translation>
    </message>
    <message>
        <source>Is drawn</source>
        <translation>绘制</translation>
    </message>
    <message>
        <source>Left out before, and drawn after all</source>
        <translation>先被剔除，最终仍绘制</translation>
    </message>
    <message>
        <source>Tested</source>
        <translation>已测试</translation>
    </message>
    <message>
        <source>Triangles of the strategy&apos;s own are drawn: %1</source>
        <translation>绘制策略自己的三角形：%1 个</translation>
    </message>
    <message>
        <source>A picture that the strategy made is shown: %1 × %2 pixels</source>
        <translation>显示策略生成的图像：%1 × %2 像素</translation>
    </message>
    <message>
        <source>Object %1</source>
        <translation>物体 %1</translation>
    </message>
    <message>
        <source>Node %1</source>
        <translation>节点 %1</translation>
    </message>
    <message>
        <source>Cell %1 of %2</source>
        <translation>%2 的单元 %1</translation>
    </message>
    <message>
        <source>Cell %1</source>
        <translation>单元 %1</translation>
    </message>
    <message>
        <source>Ray %1 to %2</source>
        <translation>射向 %2 的光线 %1</translation>
    </message>
    <message>
        <source>Ray %1</source>
        <translation>光线 %1</translation>
    </message>
    <message>
        <source>Band %1 of %2</source>
        <translation>%2 的带 %1</translation>
    </message>
    <message>
        <source>Band %1</source>
        <translation>带 %1</translation>
    </message>
    <message>
        <source>Piece %1 of a row, of %2</source>
        <translation>%2 的行段 %1</translation>
    </message>
    <message>
        <source>Piece %1 of a row</source>
        <translation>行段 %1</translation>
    </message>
    <message>
        <source>N poses before the scene&apos;s front, looking along -z, which the scene fills</source>
        <translation>场景正面前方沿 -z 观看、由场景填满的 N 个姿态</translation>
    </message>
    <message>
        <source>%1, line %2: &quot;%3&quot; is none of polygon, plane, eye and camera. Write one of them, or # before a comment.</source>
        <translation>%1 第 %2 行：“%3”不是 polygon、plane、eye、camera 之一。请写其中之一，或在注释前加 #。</translation>
    </message>
    <message>
        <source>%1, line %2: the camera looks at its own place. Give it another target.</source>
        <translation>%1 第 %2 行：相机看向自身所在的位置。请给出另一个目标点。</translation>
    </message>
    <message>
        <source>%1, line %2: a name is missing before the numbers. Write for example polygon A 0 0 0  1 0 0  0 1 0.</source>
        <translation>%1 第 %2 行：数字之前缺少名称。例如写成 polygon A 0 0 0  1 0 0  0 1 0。</translation>
    </message>
    <message>
        <source>%1, line %2: the name &quot;%3&quot; is used twice. Give each its own.</source>
        <translation>%1 第 %2 行：名称“%3”用了两次。请各取其名。</translation>
    </message>
    <message>
        <source>%1, line %2: a polygon has three coordinates for each of three or more corners; here are %3 numbers.</source>
        <translation>%1 第 %2 行：多边形有三个或更多顶点，每个顶点三个坐标；此处有 %3 个数。</translation>
    </message>
    <message>
        <source>%1, line %2: the polygon&apos;s corners do not lie in one plane. Write it as several polygons.</source>
        <translation>%1 第 %2 行：多边形的顶点不在同一平面上。请写成多个多边形。</translation>
    </message>
    <message>
        <source>%1, line %2: a plane is written as a b c d, for ax + by + cz + d = 0, or as a point and a normal, six numbers; here are %3.</source>
        <translation>%1 第 %2 行：平面写作 a b c d，即 ax + by + cz + d = 0，或写作一点和法线共六个数；此处有 %3 个。</translation>
    </message>
    <message>
        <source>%1, line %2: the file has a camera already.</source>
        <translation>%1 第 %2 行：文件已有相机。</translation>
    </message>
    <message>
        <source>%1, line %2: an eye has three numbers, a camera six: its place and where it looks.</source>
        <translation>%1 第 %2 行：eye 有三个数，camera 有六个数：位置和目标点。</translation>
    </message>
    <message>
        <source>sheets one behind the other, each an object: seen from the front, the first one hides the others</source>
        <translation>前后排列的薄片，每片一个物体：从正面看，第一片遮住其余各片</translation>
    </message>
    <message>
        <source>how many layers</source>
        <translation>层数</translation>
    </message>
    <message>
        <source>how many triangles each layer has, to the nearest that its grid allows</source>
        <translation>每层的三角形数，取其网格允许的最接近值</translation>
    </message>
    <message>
        <source>height of the layers&apos; waves; 0: they are flat</source>
        <translation>各层波浪的高度；0：平坦</translation>
    </message>
    <message>
        <source>the lecture&apos;s quiz: polygons A, B and C, and the planes P1 to P3 that divide them</source>
        <translation>课程测验：多边形 A、B、C 以及划分它们的平面 P1 至 P3</translation>
    </message>
    <message>
        <source>the lecture&apos;s worked example: polygons A to D, divided by the planes P1 and P2</source>
        <translation>课程例题：由平面 P1 和 P2 划分的多边形 A 至 D</translation>
    </message>
    <message>
        <source>plane=given takes the planes that a scene has. &quot;%1&quot; has none: name them in a .polygons file, or take another choice of plane.</source>
        <translation>plane=given 使用场景自带的平面。“%1”没有平面：请在 .polygons 文件中写出，或改用其他选法。</translation>
    </message>
    <message>
        <source>Building the BSP tree</source>
        <translation>正在构建 BSP 树</translation>
    </message>
    <message>
        <source>The BSP tree of &quot;%1&quot; needs more than %2 polygons: its %3 triangles were cut %4 times, and %5 polygons are not divided yet. Take fewer triangles, another choice of plane (plane=fewest), or a higher limit.</source>
        <translation>“%1”的 BSP 树需要超过 %2 个多边形：其 %3 个三角形已被切割 %4 次，还有 %5 个多边形未划分。请减少三角形，改用其他平面选法（plane=fewest），或提高上限。</translation>
    </message>
    <message>
        <source>The painter&apos;s order of &quot;%1&quot; needs more than %2 polygons: its %3 triangles were cut %4 times. Take fewer triangles, sort=centroid, or a higher limit.</source>
        <translation>“%1”的画家顺序需要超过 %2 个多边形：其 %3 个三角形已被切割 %4 次。请减少三角形，改用 sort=centroid，或提高上限。</translation>
    </message>
    <message>
        <source>groups outside the frustum</source>
        <translation>视锥体外的组</translation>
    </message>
    <message>
        <source>groups visible without asking</source>
        <translation>无需询问即可见的组</translation>
    </message>
    <message>
        <source>groups asked about</source>
        <translation>询问过的组</translation>
    </message>
    <message>
        <source>groups hidden</source>
        <translation>被遮挡的组</translation>
    </message>
    <message>
        <source>objects drawn</source>
        <translation>绘制的物体</translation>
    </message>
    <message>
        <source>walk and queries</source>
        <translation>遍历与查询</translation>
    </message>
    <message>
        <source>The object &quot;%1&quot; lies in a box of the octree; it has %2 triangles.</source>
        <translation>物体&quot;%1&quot;位于八叉树的一个盒子中；它有 %2 个三角形。</translation>
    </message>
    <message>
        <source>It lies in a group of %1 objects, of which all are drawn where their box is visible.</source>
        <translation>它属于一个有 %1 个物体的组，组的盒子可见时全部绘制。</translation>
    </message>
    <message>
        <source>visit(group)</source>
        <translation>访问(组)</translation>
    </message>
    <message>
        <source>test its box against the frustum</source>
        <translation>用视锥体测试其盒子</translation>
    </message>
    <message>
        <source>first, or across near plane: visible</source>
        <translation>第一个或跨越近平面：可见</translation>
    </message>
    <message>
        <source>else ask OpenGL: does its box show?</source>
        <translation>否则问 OpenGL：盒子可见吗？</translation>
    </message>
    <message>
        <source>no: hidden, leave all its objects out</source>
        <translation>否：被遮挡，剔除其全部物体</translation>
    </message>
    <message>
        <source>yes: visit(parts), nearest first</source>
        <translation>是：访问(各部分)，由近及远</translation>
    </message>
    <message>
        <source>no parts: draw its objects</source>
        <translation>没有部分：绘制其物体</translation>
    </message>
    <message>
        <source>Octree with occlusion queries</source>
        <translation>带遮挡查询的八叉树</translation>
    </message>
    <message>
        <source>Draws an octree&apos;s objects from near to far, and first asks OpenGL of each group whether its box shows.</source>
        <translation>由近及远绘制八叉树中的物体，并先就每个组询问 OpenGL 其盒子是否可见。</translation>
    </message>
    <message>
        <source>How many frames later an answer is used; 0: each batch is waited for, and nothing is lost.</source>
        <translation>答案在多少帧之后使用；0：等待每一批的答案，不会丢失任何内容。</translation>
    </message>
    <message>
        <source>How many boxes are asked about at once, at most: more need fewer waits, and hide less from each other. The lecture asks one by one.</source>
        <translation>一次最多询问多少个盒子：越多等待越少，但彼此遮挡也越少。讲义中逐个询问。</translation>
    </message>
    <message>
        <source>Which groups OpenGL is asked about.</source>
        <translation>就哪些组询问 OpenGL。</translation>
    </message>
    <message>
        <source>every group before its parts</source>
        <translation>每个组，先于其各部分</translation>
    </message>
    <message>
        <source>only groups without parts, as in the lecture</source>
        <translation>只问没有部分的组，与讲义相同</translation>
    </message>
    <message>
        <source>How many objects a group may have that is not divided into parts.</source>
        <translation>不再划分的组最多可有多少个物体。</translation>
    </message>
    <message>
        <source>Groups by what was asked</source>
        <translation>按询问结果划分的组</translation>
    </message>
    <message>
        <source>Nothing is drawn yet that could hide its box: it counts as visible without asking.</source>
        <translation>尚未绘制任何可能遮住其盒子的内容：不询问即视为可见。</translation>
    </message>
    <message>
        <source>OpenGL was asked about its box, grown by %2: it shows before what is drawn.</source>
        <translation>就扩大 %2 后的盒子询问了 OpenGL：它显示在已绘制内容之前。</translation>
    </message>
    <message>
        <source>OpenGL was asked about its box, grown by %2: what is drawn hides all of it.</source>
        <translation>就扩大 %2 后的盒子询问了 OpenGL：已绘制内容将其完全遮住。</translation>
    </message>
    <message>
        <source>Its box was not asked about %1 frames ago: it counts as visible, and is asked about now.</source>
        <translation>%1 帧之前没有询问其盒子：视为可见，现在询问。</translation>
    </message>
    <message>
        <source>Its box, grown by %2, is asked about; %1 frames ago the answer was that it shows.</source>
        <translation>询问扩大 %2 后的盒子；%1 帧之前的答案是可见。</translation>
    </message>
    <message>
        <source>Its box, grown by %2, is asked about; %1 frames ago the answer was that it is hidden.</source>
        <translation>询问扩大 %2 后的盒子；%1 帧之前的答案是被遮挡。</translation>
    </message>
    <message>
        <source>The box counts as visible: its parts are visited, nearest first.</source>
        <translation>盒子视为可见：由近及远访问其各部分。</translation>
    </message>
    <message>
        <source>The eye lies %1 before the plane of node %2.</source>
        <translation>视点在节点 %2 的平面正面，距离 %1。</translation>
    </message>
    <message>
        <source>The eye lies %1 behind the plane of node %2.</source>
        <translation>视点在节点 %2 的平面背面，距离 %1。</translation>
    </message>
    <message>
        <source>The eye lies in the plane of node %2, at %1: its sides may come in any order.</source>
        <translation>视点在节点 %2 的平面上（%1）：两侧可按任意顺序。</translation>
    </message>
    <message>
        <source>A part with %1 of the area of triangle %2 is drawn, with node %3.</source>
        <translation>在节点 %3 处绘制占三角形 %2 面积 %1 的部分。</translation>
    </message>
    <message>
        <source>the eye is before the plane</source>
        <translation>视点在平面正面</translation>
    </message>
    <message>
        <source>the eye is behind the plane</source>
        <translation>视点在平面背面</translation>
    </message>
    <message>
        <source>the eye is in the plane</source>
        <translation>视点在平面上</translation>
    </message>
    <message>
        <source>The tree has the triangle in %1 parts, each drawn where the walk comes to it.</source>
        <translation>树中该三角形有 %1 个部分，遍历到哪里就在哪里绘制。</translation>
    </message>
    <message>
        <source>walking the tree</source>
        <translation>遍历树</translation>
    </message>
    <message>
        <source>The walk starts at the root: %1 nodes, %2 polygons.</source>
        <translation>遍历从根开始：%1 个节点，%2 个多边形。</translation>
    </message>
    <message>
        <source>Splitting planes</source>
        <translation>分割平面</translation>
    </message>
    <message>
        <source>&amp;Splitting planes</source>
        <translation>分割平面(&amp;S)</translation>
    </message>
    <message>
        <source>Show in the active view the first planes of the BSP tree, each within its cell</source>
        <translation>在活动视图中显示 BSP 树的前若干平面，各在其单元内</translation>
    </message>
    <message>
        <source>node = root</source>
        <translation>节点 = 根</translation>
    </message>
    <message>
        <source>s = side of node&apos;s plane that V is on</source>
        <translation>s = V 在节点平面的哪一侧</translation>
    </message>
    <message>
        <source>draw what lies in the plane</source>
        <translation>绘制位于平面上的部分</translation>
    </message>
    <message>
        <source>In which order the tree is walked.</source>
        <translation>遍历树的顺序。</translation>
    </message>
    <message>
        <source>far to near, without depth test</source>
        <translation>由远到近，不做深度测试</translation>
    </message>
    <message>
        <source>near to far, with depth test</source>
        <translation>由近到远，做深度测试</translation>
    </message>
    <message>
        <source>Which plane divides the polygons of a node.</source>
        <translation>用哪个平面划分节点的多边形。</translation>
    </message>
    <message>
        <source>that of its first polygon</source>
        <translation>其第一个多边形的平面</translation>
    </message>
    <message>
        <source>of some candidates the one that cuts the fewest polygons</source>
        <translation>候选中切割多边形最少者</translation>
    </message>
    <message>
        <source>of some candidates the one that divides them best</source>
        <translation>候选中划分最均衡者</translation>
    </message>
    <message>
        <source>the planes that the scene names, one for each level</source>
        <translation>场景命名的平面，每层一个</translation>
    </message>
    <message>
        <source>How many planes are tried at a node (plane=fewest and balance).</source>
        <translation>每个节点试几个平面（plane=fewest 和 balance）。</translation>
    </message>
    <message>
        <source>BSP tree</source>
        <translation>BSP 树</translation>
    </message>
    <message>
        <source>Draws all triangles in the order of a BSP tree, cut where its planes pass through them.</source>
        <translation>按 BSP 树的顺序绘制全部三角形，平面穿过处将其切开。</translation>
    </message>
    <message>
        <source>Nodes by the eye&apos;s side</source>
        <translation>按视点所在侧统计节点</translation>
    </message>
    <message>
        <source>Nothing is left that has to come before: %1 of the area of triangle %2 is drawn.</source>
        <translation>没有必须先画的了：绘制三角形 %2 面积的 %1。</translation>
    </message>
    <message>
        <source>3: P is behind Q&apos;s plane</source>
        <translation>3：P 在 Q 的平面之后</translation>
    </message>
    <message>
        <source>4: Q is before P&apos;s plane</source>
        <translation>4：Q 在 P 的平面之前</translation>
    </message>
    <message>
        <source>5: projections apart</source>
        <translation>5：投影分离</translation>
    </message>
    <message>
        <source>Q is taken first</source>
        <translation>先取 Q</translation>
    </message>
    <message>
        <source>one is cut</source>
        <translation>切开一个</translation>
    </message>
    <message>
        <source>sorting</source>
        <translation>排序</translation>
    </message>
    <message>
        <source>%1 polygons are sorted by their farthest depth.</source>
        <translation>%1 个多边形按最远深度排序。</translation>
    </message>
    <message>
        <source>P = the farthest one left</source>
        <translation>P = 剩余中最远者</translation>
    </message>
    <message>
        <source>for each Q that P overlaps in depth</source>
        <translation>对深度与 P 重叠的每个 Q</translation>
    </message>
    <message>
        <source>1, 2: apart in x or y? next Q</source>
        <translation>1、2：x 或 y 分离？下一个 Q</translation>
    </message>
    <message>
        <source>3: P behind Q&apos;s plane? next Q</source>
        <translation>3：P 在 Q 平面之后？下一个 Q</translation>
    </message>
    <message>
        <source>4: Q before P&apos;s plane? next Q</source>
        <translation>4：Q 在 P 平面之前？下一个 Q</translation>
    </message>
    <message>
        <source>5: projections apart? next Q</source>
        <translation>5：投影分离？下一个 Q</translation>
    </message>
    <message>
        <source>Q marked, or they pierce: cut</source>
        <translation>Q 已标记或互穿：切开</translation>
    </message>
    <message>
        <source>else mark P; P = Q, from line 3</source>
        <translation>否则标记 P；P = Q，回到第 3 行</translation>
    </message>
    <message>
        <source>Painter&apos;s algorithm</source>
        <translation>画家算法</translation>
    </message>
    <message>
        <source>Draws all triangles from far to near without depth test, and cuts those that wait for each other.</source>
        <translation>不做深度测试，由远到近绘制全部三角形，互相等待者被切开。</translation>
    </message>
    <message>
        <source>How the triangles are sorted.</source>
        <translation>三角形的排序方法。</translation>
    </message>
    <message>
        <source>by the tests of Newell, Newell and Sancha</source>
        <translation>用 Newell、Newell 和 Sancha 的测试</translation>
    </message>
    <message>
        <source>by the distance of their centroids alone; shows wrong pixels</source>
        <translation>仅按质心距离；会显示错误像素</translation>
    </message>
    <message>
        <source>How many polygons a frame may have, the cut ones among them.</source>
        <translation>一帧最多可有多少多边形，包括切割所得。</translation>
    </message>
    <message>
        <source>Comparisons by what decided</source>
        <translation>按决定因素统计比较</translation>
    </message>
    <message>
        <source>All normals in the cell&apos;s cone are turned to the eye: cones are not tested in its parts.</source>
        <translation>单元法线锥中的法线全都朝向视点：其各部分不再测试法线锥。</translation>
    </message>
    <message>
        <source>The planes of its triangles have the eye behind them by at least %1, more than the %2 that rounding and snapping may undo.</source>
        <translation>视点位于其三角形所在平面之后至少 %1，大于舍入和捕捉可能抵消的 %2。</translation>
    </message>
    <message>
        <source>The planes of its triangles have the eye behind them by at least %1: not more than the %2 that rounding and snapping may undo.</source>
        <translation>视点位于其三角形所在平面之后至少 %1：不大于舍入和捕捉可能抵消的 %2。</translation>
    </message>
    <message>
        <source>Its sphere reaches the slope %1; the kernel&apos;s horizon before it is not everywhere higher (%2): part of it may be visible.</source>
        <translation>其包围球达到斜率 %1；它之前内核的地平线并非处处更高（%2）：它可能部分可见。</translation>
    </message>
    <message>
        <source>Its sphere reaches the slope %1; the kernel&apos;s horizon before it is higher, at least %2: hidden.</source>
        <translation>其包围球达到斜率 %1；它之前内核的地平线更高，至少为 %2：被遮挡。</translation>
    </message>
    <message>
        <source>Its sphere begins at the slope %1, above the kernel&apos;s horizon, at most %2: the kernel hides none of it.</source>
        <translation>其包围球自斜率 %1 起，高于至多为 %2 的内核地平线：内核不遮挡它的任何部分。</translation>
    </message>
    <message>
        <source>Left out, but drawn after all: it lies between two ranges, and fewer than %1 triangles are not worth a range of their own.</source>
        <translation>先被剔除，最终仍绘制：它位于两个区间之间，少于 %1 个三角形不值得单独成为区间。</translation>
    </message>
    <message>
        <source>Corner ray %1 passes %2 cells of the map and hits a triangle at R = %3.</source>
        <translation>角光线 %1 经过图的 %2 个单元，在 R = %3 处命中三角形。</translation>
    </message>
    <message>
        <source>A test left the cell out, but it is drawn with the ranges on both of its sides: so few triangles are not worth a range of their own.</source>
        <translation>测试剔除了该单元，但它随两侧的区间一起绘制：这么少的三角形不值得单独成为区间。</translation>
    </message>
    <message>
        <source>It lies in a group of %1 objects, whose box was tested first: what was drawn before hides it.</source>
        <translation>它属于一个有 %1 个物体的组，先测试了组的盒子：此前绘制的内容将其遮住。</translation>
    </message>
    <message>
        <source>index map</source>
        <translation>索引图</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no camera, from which the order is seen. Write a line eye x y z into its .polygons file.</source>
        <translation>“%1”没有指定观察顺序的相机。请在其 .polygons 文件中写一行 eye x y z。</translation>
    </message>
    <message>
        <source>Leaves of a BSP tree and the order of drawing</source>
        <translation>BSP 树的叶与绘制顺序</translation>
    </message>
    <message>
        <source>Computed from the scene&apos;s own planes, which divide it level by level; its objects hang at the leaves. C1 is the leaf behind all planes, the last one before all of them.</source>
        <translation>由场景自己的平面计算：平面逐层划分场景，物体挂在叶上。C1 是位于所有平面背面的叶，最后一个叶位于所有平面正面。</translation>
    </message>
    <message>
        <source>Bytes are of what the method built, of what a frame needed besides (tables, lists, its triangles or its picture), and of the GPU&apos;s depth buffer where it is used. Missed pixels are those of all views.</source>
        <translation>字节数包括方法所构建的内容、一帧另外所需的内容（表、列表、方法生成的三角形或图像），以及用到时 GPU 的深度缓冲。漏掉的像素是所有视图的总和。</translation>
    </message>
    <message>
        <source>covers no sample</source>
        <translation>不覆盖任何样本</translation>
    </message>
    <message>
        <source>About several cells</source>
        <translation>关于多个单元</translation>
    </message>
    <message>
        <source>Cells of %1</source>
        <translation>%1 的单元</translation>
    </message>
    <message>
        <source>Several cells</source>
        <translation>多个单元</translation>
    </message>
    <message>
        <source>%1 names no polygon. Write at least one line such as polygon A 0 0 0  1 0 0  0 1 0.</source>
        <translation>%1 没有指定任何多边形。请至少写一行，例如 polygon A 0 0 0  1 0 0  0 1 0。</translation>
    </message>
    <message>
        <source>The BSP tree of &quot;%1&quot; needs more than %2 nodes: each of its %3 planes divides every cell of the one before. Name fewer planes, or take a higher limit.</source>
        <translation>“%1”的 BSP 树需要超过 %2 个节点：%3 个平面各自划分前一个平面的所有单元。请减少平面，或提高上限。</translation>
    </message>
    <message>
        <source>draw it: OpenGL drops back faces</source>
        <translation>绘制它：OpenGL 丢弃背面</translation>
    </message>
    <message>
        <source>The walk comes to node %1, on the eye&apos;s side of the plane of node %2.</source>
        <translation>遍历来到节点 %1，它在节点 %2 的平面上视点所在的一侧。</translation>
    </message>
    <message>
        <source>The walk comes to node %1, beyond the plane of node %2.</source>
        <translation>遍历来到节点 %1，它在节点 %2 的平面的另一侧。</translation>
    </message>
    <message>
        <source>%1: %2 polygons</source>
        <translation>%1：%2 个多边形</translation>
    </message>
    <message>
        <source>How many polygons the tree may have, the cut ones among them, and how many nodes.</source>
        <translation>树最多可有多少个多边形（包括切开的）以及多少个节点。</translation>
    </message>
    <message>
        <source>Triangle %1 is the farthest one left, with the farthest depth %2.</source>
        <translation>三角形 %1 是剩余中最远的，最远深度为 %2。</translation>
    </message>
    <message>
        <source>The triangle lies beyond a plane of the frustum.</source>
        <translation>该三角形位于视锥体某一平面之外。</translation>
    </message>
    <message>
        <source>The triangle is turned away.</source>
        <translation>该三角形背向。</translation>
    </message>
    <message>
        <source>The triangle covers no sample: no centre of a pixel lies in it.</source>
        <translation>该三角形不覆盖任何样本：没有像素中心位于其中。</translation>
    </message>
    <message>
        <source>At every sample that the triangle covers another surface is in front.</source>
        <translation>在该三角形覆盖的每个样本处，都有其他表面在前。</translation>
    </message>
    <message>
        <source>cut: follow four corner rays</source>
        <translation>相交：跟踪四条角光线</translation>
    </message>
    <message>
        <source>cell by cell: a triangle hit?</source>
        <translation>逐个单元：是否命中三角形？</translation>
    </message>
    <message>
        <source>draw boxes of cells around it</source>
        <translation>绘制包围它的单元盒</translation>
    </message>
    <message>
        <source>yes, or the near half: draw it</source>
        <translation>是，或在近的一半：绘制</translation>
    </message>
    <message>
        <source>Sector %4, band up to α = %3°: the surface&apos;s slope is at least %1, and the horizon before it %2.</source>
        <translation>扇区 %4，至 α = %3° 的环带：表面斜率至少为 %1，其前的地平线为 %2。</translation>
    </message>
    <message>
        <source>The cell&apos;s triangles reach the slope %1; the horizon before them is higher everywhere, at least %2: hidden.</source>
        <translation>单元的三角形达到斜率 %1；之前的地平线处处更高，至少为 %2：被遮挡。</translation>
    </message>
    <message>
        <source>The cell&apos;s triangles reach the slope %1; the horizon before them is not everywhere higher (%2): drawn.</source>
        <translation>单元的三角形达到斜率 %1；之前的地平线并非处处更高（%2）：绘制。</translation>
    </message>
    <message>
        <source>The cell lies too near to the centre or to the axis, or reaches too far around: drawn without a test.</source>
        <translation>单元离中心或轴太近，或延伸范围过大：不检验直接绘制。</translation>
    </message>
    <message>
        <source>Ray %1 passes a cell in which no triangle lies.</source>
        <translation>光线 %1 经过一个没有三角形的单元。</translation>
    </message>
    <message>
        <source>Ray %1 stays at R ≥ %2 in this cell, whose triangles end at R = %3: none of them is hit.</source>
        <translation>在此单元中光线 %1 处于 R ≥ %2，而单元的三角形止于 R = %3：一个也没有命中。</translation>
    </message>
    <message>
        <source>Ray %1 stays at R ≤ %2 in this cell, whose triangles begin at R = %3: none of them is hit.</source>
        <translation>在此单元中光线 %1 处于 R ≤ %2，而单元的三角形始于 R = %3：一个也没有命中。</translation>
    </message>
    <message>
        <source>Ray %1 is at R = %2 to %3 in this cell: of its %4 triangles one is hit.</source>
        <translation>在此单元中光线 %1 处于 R = %2 至 %3：其 %4 个三角形中命中一个。</translation>
    </message>
    <message>
        <source>Ray %1 is at R = %2 to %3 in this cell: of its %4 triangles none is hit.</source>
        <translation>在此单元中光线 %1 处于 R = %2 至 %3：其 %4 个三角形一个也没有命中。</translation>
    </message>
    <message>
        <source>Corner ray %1 enters the bounding sphere at R = %2.</source>
        <translation>角光线 %1 在 R = %2 处进入包围球。</translation>
    </message>
    <message>
        <source>Sector %4, band up to α = %3°, in the near half: S %1, largest before it %2: drawn.</source>
        <translation>扇区 %4，近半球中至 α = %3° 的环带：S %1，之前的最大值 %2：绘制。</translation>
    </message>
    <message>
        <source>Sector %4, band up to α = %3°: S %1 &gt; %2, the largest before it: drawn.</source>
        <translation>扇区 %4，至 α = %3° 的环带：S %1 &gt; 之前的最大值 %2：绘制。</translation>
    </message>
    <message>
        <source>Sector %4, band up to α = %3°: S %1 ≤ %2, the largest before it: hidden.</source>
        <translation>扇区 %4，至 α = %3° 的环带：S %1 ≤ 之前的最大值 %2：被遮挡。</translation>
    </message>
    <message>
        <source>A box around the region: rows %1 to %2 of the map, columns %3 to %4.</source>
        <translation>包围该区域的盒：图的第 %1 至 %2 行，第 %3 至 %4 列。</translation>
    </message>
    <message>
        <source>Cells %1 to %2 are one range of the memory access map: %3 triangles from place %4 on are drawn.</source>
        <translation>单元 %1 至 %2 是内存访问图的一个区间：从位置 %4 起绘制 %3 个三角形。</translation>
    </message>
    <message>
        <source>not yet decided</source>
        <translation>尚未决定</translation>
    </message>
    <message>
        <source>The triangle is in the picture that the strategy made.</source>
        <translation>该三角形在此策略生成的图像中。</translation>
    </message>
    <message>
        <source>The triangle is not in the picture that the strategy made.</source>
        <translation>该三角形不在此策略生成的图像中。</translation>
    </message>
    <message>
        <source>%1, which writes and reads pictures, cannot be opened: %2. Install or build Cullscope again.</source>
        <translation>无法打开负责读写图像的 %1：%2。请重新安装或构建 Cullscope。</translation>
    </message>
    <message>
        <source>Part %1</source>
        <translation>部分 %1</translation>
    </message>
    <message>
        <source>Part of triangle %1 of %2</source>
        <translation>%2 的三角形 %1 的部分</translation>
    </message>
    <message>
        <source>Part of triangle %1</source>
        <translation>三角形 %1 的部分</translation>
    </message>
    <message>
        <source>The BSP tree of &quot;%1&quot; needs more than %2 polygons: it has %3 triangles. Take fewer triangles, or a higher limit.</source>
        <translation>“%1”的 BSP 树需要超过 %2 个多边形：它有 %3 个三角形。请减少三角形，或提高上限。</translation>
    </message>
    <message>
        <source>The BSP tree of &quot;%1&quot; needs more than %2 polygons: its %3 triangles were cut %4 times, and %5 polygons are not divided yet. Take fewer triangles, or a higher limit.</source>
        <translation>“%1”的 BSP 树需要超过 %2 个多边形：其 %3 个三角形已被切割 %4 次，还有 %5 个多边形未划分。请减少三角形，或提高上限。</translation>
    </message>
    <message>
        <source>The painter&apos;s order of &quot;%1&quot; needs more than %2 polygons: it has %3 triangles. Take fewer triangles, or a higher limit.</source>
        <translation>“%1”的画家顺序需要超过 %2 个多边形：它有 %3 个三角形。请减少三角形，或提高上限。</translation>
    </message>
    <message>
        <source>Triangle %1, which waited, is taken again; its farthest depth is %2.</source>
        <translation>等待中的三角形 %1 再次被取出，其最远深度为 %2。</translation>
    </message>
    <message>
        <source>There is no parameter &quot;%1&quot; here, and no other one.</source>
        <translation>这里没有参数“%1”，也没有其他参数。</translation>
    </message>
    <message>
        <source>The triangle covers %1 samples. At column %2 of row %3 its depth is %4.</source>
        <translation>三角形覆盖 %1 个样本。在第 %3 行第 %2 列，其深度为 %4。</translation>
    </message>
    <message>
        <source>Its depth %1 there does not exceed the stored %2. It is nearer at none of its samples.</source>
        <translation>其深度 %1 在该处不大于已存的 %2。它在任何样本上都不更近。</translation>
    </message>
    <message>
        <source>At %1 samples it is nearer, at %2 of them the first surface. There its depth %3 exceeds the stored %4: drawn.</source>
        <translation>它在 %1 个样本上更近，其中 %2 个此前没有表面。该处其深度 %3 大于已存的 %4：绘制。</translation>
    </message>
    <message>
        <source>Columns %1 to %2 are filled with it.</source>
        <translation>用它填充第 %1 列到第 %2 列。</translation>
    </message>
    <message>
        <source>Sector %4, band up to α = %3°: S %1 ≤ %2, the largest before it: hidden beyond α = 90°, drawn within it.</source>
        <translation>扇区 %4，至 α = %3° 的环带：S %1 ≤ 之前的最大值 %2：α = 90° 以外被遮挡，以内绘制。</translation>
    </message>
    <message>
        <source>About rows of the picture</source>
        <translation>关于图像的行</translation>
    </message>
    <message>
        <source>About triangles</source>
        <translation>关于三角形</translation>
    </message>
    <message>
        <source>Rows %1 of the picture</source>
        <translation>图像的第 %1 行</translation>
    </message>
    <message>
        <source>Row %1 of the picture</source>
        <translation>图像的第 %1 行</translation>
    </message>
    <message>
        <source>Triangle %1</source>
        <translation>三角形 %1</translation>
    </message>
    <message>
        <source>Triangles %1 of %2</source>
        <translation>%2 的三角形 %1</translation>
    </message>
    <message>
        <source>Triangle %1 of %2</source>
        <translation>%2 的三角形 %1</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>球</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>圆柱</translation>
    </message>
    <message>
        <source>cone</source>
        <translation>圆锥</translation>
    </message>
    <message>
        <source>eccentric cone</source>
        <translation>偏心圆锥</translation>
    </message>
    <message>
        <source>mitred cylinder</source>
        <translation>斜切圆柱</translation>
    </message>
    <message>
        <source>circular torus</source>
        <translation>圆截面圆环</translation>
    </message>
    <message>
        <source>rectangular torus</source>
        <translation>矩形截面圆环</translation>
    </message>
    <message>
        <source>ellipsoidal dish</source>
        <translation>椭球封头</translation>
    </message>
    <message>
        <source>spherical dish</source>
        <translation>球冠封头</translation>
    </message>
    <message>
        <source>torispherical head</source>
        <translation>碟形封头</translation>
    </message>
    <message>
        <source>box</source>
        <translation>长方体</translation>
    </message>
    <message>
        <source>wedge</source>
        <translation>楔体</translation>
    </message>
    <message>
        <source>pyramid</source>
        <translation>棱锥</translation>
    </message>
    <message>
        <source>frustum of a pyramid</source>
        <translation>棱台</translation>
    </message>
    <message>
        <source>prism</source>
        <translation>棱柱</translation>
    </message>
    <message>
        <source>disc</source>
        <translation>圆盘</translation>
    </message>
    <message>
        <source>ring</source>
        <translation>圆环面</translation>
    </message>
    <message>
        <source>hollow cylinder</source>
        <translation>空心圆柱</translation>
    </message>
    <message>
        <source>%1: of these sizes it has no surface, but is a point or a line.</source>
        <translation>%1：这样的尺寸没有表面，只是一个点或一条线。</translation>
    </message>
    <message>
        <source>%1: its lengths are numbers from 0 to 1e30.</source>
        <translation>%1：长度必须是 0 到 1e30 之间的数。</translation>
    </message>
    <message>
        <source>%1: its angle is more than 0 and at most 360 degrees.</source>
        <translation>%1：角度必须大于 0 且不超过 360 度。</translation>
    </message>
    <message>
        <source>%1: its inner radius is smaller than its outer one.</source>
        <translation>%1：内半径必须小于外半径。</translation>
    </message>
    <message>
        <source>%1: its ends are cut at less than 90 degrees.</source>
        <translation>%1：两端的切角必须小于 90 度。</translation>
    </message>
    <message>
        <source>%1: its slanted ends do not cut each other. Make it longer or cut it less.</source>
        <translation>%1：两个斜端面不能相交。请加长或减小切角。</translation>
    </message>
    <message>
        <source>%1: its tube is no thicker than its ring allows.</source>
        <translation>%1：管不能比圆环允许的更粗。</translation>
    </message>
    <message>
        <source>%1: its crown is at least as wide as its vessel, and its knuckle at most.</source>
        <translation>%1：冠部半径不得小于容器半径，过渡圆角半径不得大于容器半径。</translation>
    </message>
    <message>
        <source>%1: it has 3 to 1000 sides.</source>
        <translation>%1：侧面数为 3 到 1000。</translation>
    </message>
    <message>
        <source>facet group</source>
        <translation>面片组</translation>
    </message>
    <message>
        <source>line</source>
        <translation>线</translation>
    </message>
    <message>
        <source>Generating the plant</source>
        <translation>正在生成工厂</translation>
    </message>
    <message>
        <source>%1, byte %2: an RVM file begins with a record HEAD.</source>
        <translation>%1，第 %2 字节：RVM 文件以 HEAD 记录开头。</translation>
    </message>
    <message>
        <source>%1, byte %2: the record MODL is missing after HEAD.</source>
        <translation>%1，第 %2 字节：HEAD 之后缺少 MODL 记录。</translation>
    </message>
    <message>
        <source>%1, byte %2: the record &quot;%3&quot; is unknown. Export the file again.</source>
        <translation>%1，第 %2 字节：未知的记录“%3”。请重新导出文件。</translation>
    </message>
    <message>
        <source>%1, byte %2: the file ends within a group.</source>
        <translation>%1，第 %2 字节：文件在一个组内结束。</translation>
    </message>
    <message>
        <source>%1, byte %2: the record %3 is too short for what it holds.</source>
        <translation>%1，第 %2 字节：记录 %3 对其内容而言太短。</translation>
    </message>
    <message>
        <source>%1, byte %2: the file breaks off within a record. Fetch or export it again.</source>
        <translation>%1，第 %2 字节：文件在记录中间中断。请重新获取或导出。</translation>
    </message>
    <message>
        <source>%1, byte %2: here is no number but an infinity or NaN.</source>
        <translation>%1，第 %2 字节：此处不是数，而是无穷大或 NaN。</translation>
    </message>
    <message>
        <source>%1, byte %2: here is a text of %3 words, too long to be one.</source>
        <translation>%1，第 %2 字节：此处文本长 %3 个字，过长而不可能是文本。</translation>
    </message>
    <message>
        <source>%1, byte %2: here are to be %3 items, more than the record has room for.</source>
        <translation>%1，第 %2 字节：此处声称有 %3 项，超出记录所能容纳的数量。</translation>
    </message>
    <message>
        <source>%1, byte %2: the file breaks off before its record END.</source>
        <translation>%1，第 %2 字节：文件在 END 记录之前中断。</translation>
    </message>
    <message>
        <source>%1, byte %2: no record of an RVM file begins here.</source>
        <translation>%1，第 %2 字节：此处没有 RVM 文件的记录开始。</translation>
    </message>
    <message>
        <source>%1, byte %2: the next record is said to begin at byte %3, which is not after this one in the file.</source>
        <translation>%1，第 %2 字节：声称下一条记录从第 %3 字节开始，但那里不在文件中本记录之后。</translation>
    </message>
    <message>
        <source>%1, byte %2: groups lie deeper in each other than %3.</source>
        <translation>%1，第 %2 字节：组的嵌套深度超过 %3。</translation>
    </message>
    <message>
        <source>%1, byte %2: a group ends that has not begun.</source>
        <translation>%1，第 %2 字节：一个尚未开始的组结束了。</translation>
    </message>
    <message>
        <source>%1, byte %2: there is no primitive of kind %3.</source>
        <translation>%1，第 %2 字节：没有种类为 %3 的体素。</translation>
    </message>
    <message>
        <source>%1, byte %2: a primitive lies outside of all groups.</source>
        <translation>%1，第 %2 字节：一个体素不属于任何组。</translation>
    </message>
    <message>
        <source>%1 holds no surface. Export the plant with its primitives.</source>
        <translation>%1 不含任何表面。请连同体素一起导出工厂。</translation>
    </message>
    <message>
        <source>Primitives left out because no such solid exists: %1. The first, at byte %2: %3</source>
        <translation>因不存在这样的形体而剔除的体素：%1。第一个位于第 %2 字节：%3</translation>
    </message>
    <message>
        <source>Its transform is flat.</source>
        <translation>其变换是扁平的。</translation>
    </message>
    <message>
        <source>It lies beyond 1e30.</source>
        <translation>它位于 1e30 之外。</translation>
    </message>
    <message>
        <source>a process plant of primitives: pipe racks with pipelines, equipment, steel and platforms</source>
        <translation>由基本体素组成的流程工厂：带管线的管廊、设备、钢结构和平台</translation>
    </message>
    <message>
        <source>how many pipelines</source>
        <translation>管线数量</translation>
    </message>
    <message>
        <source>number that the plant starts from</source>
        <translation>生成工厂的种子数</translation>
    </message>
    <message>
        <source>for batches of spheres, then of boxes</source>
        <translation>成批测试球，然后测试盒</translation>
    </message>
    <message>
        <source>for each plane, until all are outside</source>
        <translation>逐个平面，直到全部在外</translation>
    </message>
    <message>
        <source>d = how far each one reaches in</source>
        <translation>d = 各自伸入内侧的距离</translation>
    </message>
    <message>
        <source>outside: those with d &lt; −margin</source>
        <translation>在外：d &lt; −容差者</translation>
    </message>
    <message>
        <source>the first %1 nodes alone</source>
        <translation>仅前 %1 个节点</translation>
    </message>
    <message>
        <source>The farthest depth %4 of triangle %2 does not exceed the nearest depth %3 of triangle %1: it lies nearer, and so do all after it.</source>
        <translation>三角形 %2 的最远深度 %4 不超过三角形 %1 的最近深度 %3：它及其后的所有三角形都更近。</translation>
    </message>
    <message>
        <source>The farthest depth %4 of triangle %2 exceeds the nearest depth %3 of triangle %1: they overlap in depth.</source>
        <translation>三角形 %2 的最远深度 %4 超过三角形 %1 的最近深度 %3：两者在深度上重叠。</translation>
    </message>
    <message>
        <source>Test 1: in x triangle %1 ends at pixel %3 and triangle %2 at %4: they are apart.</source>
        <translation>测试 1：在 x 方向，三角形 %1 止于像素 %3，三角形 %2 止于 %4：两者分离。</translation>
    </message>
    <message>
        <source>Test 1: in x both triangles %1 and %2 have the pixels from %3 to %4: not apart.</source>
        <translation>测试 1：在 x 方向，三角形 %1 与 %2 都占有像素 %3 到 %4：并未分离。</translation>
    </message>
    <message>
        <source>Test 2: in y triangle %1 ends at pixel %3 and triangle %2 at %4: they are apart.</source>
        <translation>测试 2：在 y 方向，三角形 %1 止于像素 %3，三角形 %2 止于 %4：两者分离。</translation>
    </message>
    <message>
        <source>Test 2: in y both triangles %1 and %2 have the pixels from %3 to %4: not apart.</source>
        <translation>测试 2：在 y 方向，三角形 %1 与 %2 都占有像素 %3 到 %4：并未分离。</translation>
    </message>
    <message>
        <source>Test 3: triangle %1 reaches %3 before the plane of triangle %2, seen from the eye, and %4 behind it: it lies wholly behind.</source>
        <translation>测试 3：从视点看，三角形 %1 伸到三角形 %2 的平面之前 %3、之后 %4：它完全在后。</translation>
    </message>
    <message>
        <source>Test 3: triangle %1 reaches %3 before the plane of triangle %2, seen from the eye, and %4 behind it: it does not lie wholly behind.</source>
        <translation>测试 3：从视点看，三角形 %1 伸到三角形 %2 的平面之前 %3、之后 %4：它并非完全在后。</translation>
    </message>
    <message>
        <source>Test 4: triangle %2 reaches %3 before the plane of triangle %1, seen from the eye, and %4 behind it: it lies wholly before.</source>
        <translation>测试 4：从视点看，三角形 %2 伸到三角形 %1 的平面之前 %3、之后 %4：它完全在前。</translation>
    </message>
    <message>
        <source>Test 4: triangle %2 reaches %3 before the plane of triangle %1, seen from the eye, and %4 behind it: it does not lie wholly before.</source>
        <translation>测试 4：从视点看，三角形 %2 伸到三角形 %1 的平面之前 %3、之后 %4：它并非完全在前。</translation>
    </message>
    <message>
        <source>No test lets triangle %1, with the farthest depth %3, come before triangle %2, with %4: the second one is taken first.</source>
        <translation>没有测试允许最远深度为 %3 的三角形 %1 先于最远深度为 %4 的三角形 %2：先取后者。</translation>
    </message>
    <message>
        <source>Triangle %1, with the farthest depth %3, waits for triangle %2, with %4, which is marked: a cycle, in which one is cut.</source>
        <translation>最远深度为 %3 的三角形 %1 等待已标记的三角形 %2（最远深度 %4）：构成循环，切开其中一个。</translation>
    </message>
    <message>
        <source>Triangles %1 and %2 pass through each other: 1 / depth of the first less that of the second goes from %3 to %4. One of them is cut.</source>
        <translation>三角形 %1 与 %2 互相穿过：前者的 1/深度 减后者的从 %3 到 %4。切开其中一个。</translation>
    </message>
    <message>
        <source>Test 5: where the projections of triangles %1 and %2 overlap, 1 / depth of the first less that of the second goes from %3 to %4: it is nowhere nearer.</source>
        <translation>测试 5：在三角形 %1 与 %2 的投影重叠处，前者的 1/深度 减后者的从 %3 到 %4：前者处处不更近。</translation>
    </message>
    <message>
        <source>Test 5: where the projections of triangles %1 and %2 overlap, 1 / depth of the first less that of the second goes from %3 to %4: it is nearer somewhere.</source>
        <translation>测试 5：在三角形 %1 与 %2 的投影重叠处，前者的 1/深度 减后者的从 %3 到 %4：前者在某处更近。</translation>
    </message>
    <message>
        <source>Test 5: the projections of triangles %1 and %2 overlap by %3 pixels, not by more than %4: they count as apart.</source>
        <translation>测试 5：三角形 %1 与 %2 的投影重叠 %3 像素，不超过 %4：视为分离。</translation>
    </message>
    <message>
        <source>Test 5: the projections of triangles %1 and %2 overlap by %3 pixels, by more than %4: not apart.</source>
        <translation>测试 5：三角形 %1 与 %2 的投影重叠 %3 像素，超过 %4：并未分离。</translation>
    </message>
    <message>
        <source>drawn polygons alone, above %1 triangles</source>
        <translation>三角形超过 %1 个，仅记录绘制的多边形</translation>
    </message>
    <message>
        <source>without depths and tests 1 and 2, above %1 triangles</source>
        <translation>三角形超过 %1 个，省略深度比较和测试 1、2</translation>
    </message>
    <message>
        <source>the first %1 tests alone</source>
        <translation>仅前 %1 个测试</translation>
    </message>
    <message>
        <source>the first %1 polygons alone</source>
        <translation>仅前 %1 个多边形</translation>
    </message>
    <message>
        <source>Colours by verdict</source>
        <translation>按判定着色</translation>
    </message>
    <message>
        <source>Colours by &amp;verdict</source>
        <translation>按判定着色(&amp;V)</translation>
    </message>
    <message>
        <source>Colour the active view by what became of each triangle</source>
        <translation>按每个三角形的结果为活动视图着色</translation>
    </message>
    <message>
        <source>With verdicts, what was left out too</source>
        <translation>按判定着色时也显示被剔除的部分</translation>
    </message>
    <message>
        <source>The culling camera&apos;s frustum</source>
        <translation>剔除相机的视锥体</translation>
    </message>
    <message>
        <source>F&amp;rustum</source>
        <translation>视锥体(&amp;R)</translation>
    </message>
    <message>
        <source>Show the culling camera&apos;s frustum in the active view</source>
        <translation>在活动视图中显示剔除相机的视锥体</translation>
    </message>
    <message>
        <source>The boxes that were tested</source>
        <translation>被测试的包围盒</translation>
    </message>
    <message>
        <source>&amp;Boxes</source>
        <translation>包围盒(&amp;B)</translation>
    </message>
    <message>
        <source>Show the boxes that the strategy tested in the active view</source>
        <translation>在活动视图中显示策略测试的包围盒</translation>
    </message>
    <message>
        <source>Boxes by the plane that rejected them</source>
        <translation>按剔除平面着色的盒</translation>
    </message>
    <message>
        <source>Boxes by rejecting &amp;plane</source>
        <translation>按剔除平面着色的盒(&amp;P)</translation>
    </message>
    <message>
        <source>Show the boxes in the active view in the colour of the plane of the frustum that rejected them; the frustum&apos;s planes have the same colours</source>
        <translation>在活动视图中以剔除它的视锥体平面的颜色显示各盒；视锥体的平面用同样的颜色</translation>
    </message>
    <message>
        <source>Model in spherical coordinates</source>
        <translation>球坐标中的模型</translation>
    </message>
    <message>
        <source>Model in &amp;spherical coordinates</source>
        <translation>球坐标中的模型(&amp;S)</translation>
    </message>
    <message>
        <source>Show what was drawn of one object over azimuth and zenith angle in the active view</source>
        <translation>在活动视图中，按方位角和天顶角显示一个物体中被绘制的部分</translation>
    </message>
    <message>
        <source>Components by occupancy value</source>
        <translation>按占屏值统计的构件</translation>
    </message>
    <message>
        <source>octrees</source>
        <translation>八叉树</translation>
    </message>
    <message>
        <source>Largest value %1 ÷ distance %2 = %3 &lt; %4: its components count as too small.</source>
        <translation>最大值 %1 ÷ 距离 %2 = %3 &lt; %4：其构件视为过小。</translation>
    </message>
    <message>
        <source>Largest value %1 ÷ distance %2 = %3 ≥ %4: its components are drawn.</source>
        <translation>最大值 %1 ÷ 距离 %2 = %3 ≥ %4：绘制其构件。</translation>
    </message>
    <message>
        <source>The camera rests: %1 components of the outline and %2 others, none of them too small.</source>
        <translation>相机静止：轮廓构件 %1 个，其他 %2 个，均不视为过小。</translation>
    </message>
    <message>
        <source>%1 components of the outline are in octree L, %2 others in octree S.</source>
        <translation>轮廓构件 %1 个在八叉树 L 中，其他 %2 个在八叉树 S 中。</translation>
    </message>
    <message>
        <source>The component &quot;%1&quot; has %2 triangles; it is drawn with its leaf or not at all.</source>
        <translation>构件“%1”有 %2 个三角形；它随其叶节点一起绘制或不绘制。</translation>
    </message>
    <message>
        <source>It lies in a leaf of %1 components, which is drawn as a whole.</source>
        <translation>它位于有 %1 个构件的叶节点中，该叶节点整体绘制。</translation>
    </message>
    <message>
        <source>Octree %1: %2 components</source>
        <translation>八叉树 %1：%2 个构件</translation>
    </message>
    <message>
        <source>for each node of octrees L and S</source>
        <translation>对八叉树 L 和 S 的每个节点</translation>
    </message>
    <message>
        <source>test its box against the six planes</source>
        <translation>用六个平面测试其包围盒</translation>
    </message>
    <message>
        <source>outside: leave its components out</source>
        <translation>在外：剔除其构件</translation>
    </message>
    <message>
        <source>leaf of L: draw its components</source>
        <translation>L 的叶节点：绘制其构件</translation>
    </message>
    <message>
        <source>leaf of S: t = value ÷ distance</source>
        <translation>S 的叶节点：t = 值 ÷ 距离</translation>
    </message>
    <message>
        <source>if t &lt; k′·tan θ: leave it out</source>
        <translation>若 t &lt; k′·tan θ：剔除</translation>
    </message>
    <message>
        <source>else draw its components</source>
        <translation>否则绘制其构件</translation>
    </message>
    <message>
        <source>How many of the components, the largest ones, are the outline, which is always drawn. The paper names no number.</source>
        <translation>最大的构件所占的比例：它们是始终绘制的轮廓。论文未给出数值。</translation>
    </message>
    <message>
        <source>A leaf is left out where its largest occupancy value, divided by its distance, is below this: k′·tan θ.</source>
        <translation>叶节点的最大占屏值除以距离小于此值时剔除：k′·tan θ。</translation>
    </message>
    <message>
        <source>Levels of octree L, which holds the outline; the root is one of them.</source>
        <translation>包含轮廓的八叉树 L 的层数（含根节点）。</translation>
    </message>
    <message>
        <source>Levels of octree S, which holds the details; the root is one of them.</source>
        <translation>包含细节的八叉树 S 的层数（含根节点）。</translation>
    </message>
    <message>
        <source>Which box of a node is tested and has the distance; the paper can be read both ways.</source>
        <translation>测试节点的哪个包围盒并取其距离；论文可作两种理解。</translation>
    </message>
    <message>
        <source>the box around its components</source>
        <translation>其构件的包围盒</translation>
    </message>
    <message>
        <source>the octree&apos;s cell, over which components reach</source>
        <translation>八叉树的单元，构件可能超出它</translation>
    </message>
    <message>
        <source>What is drawn while the camera does not move.</source>
        <translation>相机不动时绘制的内容。</translation>
    </message>
    <message>
        <source>the same as in motion</source>
        <translation>与运动时相同</translation>
    </message>
    <message>
        <source>everything in the frustum, as in the paper&apos;s Figure 8</source>
        <translation>视锥体内的一切，如论文图 8</translation>
    </message>
    <message>
        <source>Small-feature culling</source>
        <translation>细节剔除</translation>
    </message>
    <message>
        <source>Leaves out groups of components that are too small for their distance; a plant&apos;s outline stays.</source>
        <translation>剔除相对距离过小的构件组；工厂的轮廓保留。</translation>
    </message>
    <message>
        <source>components</source>
        <translation>构件</translation>
    </message>
    <message>
        <source>Its box covers at most %1 pixels, no more than the %2 that may be lost.</source>
        <translation>其包围盒最多覆盖 %1 个像素，不超过允许损失的 %2 个。</translation>
    </message>
    <message>
        <source>Its box covers up to %1 pixels, more than the %2 that may be lost.</source>
        <translation>其包围盒覆盖多达 %1 个像素，超过允许损失的 %2 个。</translation>
    </message>
    <message>
        <source>With the small components of its group it covers at most %1 pixels, no more than the %2 that may be lost.</source>
        <translation>它与组内的小构件一起最多覆盖 %1 个像素，不超过允许损失的 %2 个。</translation>
    </message>
    <message>
        <source>With the small components of its group it covers up to %1 pixels, more than the %2 that may be lost.</source>
        <translation>它与组内的小构件一起覆盖多达 %1 个像素，超过允许损失的 %2 个。</translation>
    </message>
    <message>
        <source>Its box covers at most %1 pixels; %2 may be lost of a group.</source>
        <translation>其包围盒最多覆盖 %1 个像素；每组允许损失 %2 个。</translation>
    </message>
    <message>
        <source>Of the component &quot;%1&quot; with %2 triangles the pixels that its box covers are counted.</source>
        <translation>对有 %2 个三角形的构件“%1”，计数其包围盒覆盖的像素。</translation>
    </message>
    <message>
        <source>It lies in a group of %1 components, which covers too many pixels to be left out as a whole.</source>
        <translation>它位于有 %1 个构件的组中，该组覆盖的像素过多，不能整体剔除。</translation>
    </message>
    <message>
        <source>for each group: planes and axes</source>
        <translation>对每一组：平面与轴</translation>
    </message>
    <message>
        <source>n = pixels that its box covers</source>
        <translation>n = 其包围盒覆盖的像素数</translation>
    </message>
    <message>
        <source>if n ≤ pixels: leave the group out</source>
        <translation>若 n ≤ pixels：剔除该组</translation>
    </message>
    <message>
        <source>for each component: n of its box</source>
        <translation>对每个构件：其包围盒的 n</translation>
    </message>
    <message>
        <source>if n = 0: leave it out</source>
        <translation>若 n = 0：剔除</translation>
    </message>
    <message>
        <source>if n ≤ pixels: it is a small one</source>
        <translation>若 n ≤ pixels：它是小构件</translation>
    </message>
    <message>
        <source>small ones&apos; sum ≤ pixels: leave out</source>
        <translation>小构件之和 ≤ pixels：剔除</translation>
    </message>
    <message>
        <source>draw the others, nearest first</source>
        <translation>由近到远绘制其余</translation>
    </message>
    <message>
        <source>How many pixels a group of components may lose. With 0 nothing visible is lost.</source>
        <translation>一组构件允许损失的像素数。为 0 时不损失任何可见内容。</translation>
    </message>
    <message>
        <source>Bounded small-feature culling</source>
        <translation>有界细节剔除</translation>
    </message>
    <message>
        <source>Leaves out small components where the pixels that a group may lose by it stay under a bound.</source>
        <translation>在一组可能损失的像素不超过界限处剔除小构件。</translation>
    </message>
    <message>
        <source>The object &quot;%1&quot; is tested as one box, then each of its %2 triangles by its size.</source>
        <translation>物体“%1”先作为一个包围盒测试，再按大小逐个测试其 %2 个三角形。</translation>
    </message>
    <message>
        <source>Of %1 triangles %2 have half a longest edge below %3 of their distance: too small.</source>
        <translation>%1 个三角形中有 %2 个的最长边之半小于距离的 %3：过小。</translation>
    </message>
    <message>
        <source>Its %1 triangles are decided together: the least ratio that any of them can have is %2, no less than %3.</source>
        <translation>其 %1 个三角形一并判定：其中任何一个可能的最小比值为 %2，不小于 %3。</translation>
    </message>
    <message>
        <source>Its %1 triangles are decided together: the largest ratio that any of them can have is %2, below %3: too small.</source>
        <translation>其 %1 个三角形一并判定：其中任何一个可能的最大比值为 %2，小于 %3：过小。</translation>
    </message>
    <message>
        <source>else its parts, then each object</source>
        <translation>否则其各部分，然后每个物体</translation>
    </message>
    <message>
        <source>for each triangle of those kept</source>
        <translation>对保留者的每个三角形</translation>
    </message>
    <message>
        <source>t = ½ longest edge ÷ distance</source>
        <translation>t = ½ 最长边 ÷ 距离</translation>
    </message>
    <message>
        <source>draw those with t ≥ threshold</source>
        <translation>绘制 t ≥ threshold 者</translation>
    </message>
    <message>
        <source>A triangle is left out where half its longest edge, divided by its distance, is below this.</source>
        <translation>三角形最长边之半除以距离小于此值时剔除。</translation>
    </message>
    <message>
        <source>Small-feature culling by triangle</source>
        <translation>按三角形的细节剔除</translation>
    </message>
    <message>
        <source>Leaves out every triangle that is too small for its distance: the traditional way.</source>
        <translation>剔除所有相对距离过小的三角形：传统方法。</translation>
    </message>
    <message>
        <source>by bands of rows, above %1 triangles</source>
        <translation>三角形超过 %1 个，按行带</translation>
    </message>
    <message>
        <source>by bands of rows, above %1 pixels to look at</source>
        <translation>要查看的像素超过 %1 个，按行带</translation>
    </message>
    <message>
        <source>In these rows %1 depths were compared with the stored ones; %2 were nearer and stored. %3 pixels show a surface.</source>
        <translation>这些行中有 %1 个深度与已存深度比较；%2 个更近并被存入。%3 个像素显示表面。</translation>
    </message>
    <message>
        <source>causes by object, above %1 groups of triangles</source>
        <translation>三角形组超过 %1 个，原因按物体</translation>
    </message>
    <message>
        <source>by row, above %1 spans</source>
        <translation>扫描段超过 %1 个，按行</translation>
    </message>
    <message>
        <source>without single edges, above %1 of them</source>
        <translation>边超过 %1 条，不逐条记录</translation>
    </message>
    <message>
        <source>An edge of it is active: in row %1 it lies at x = %2, and the triangle begins at column %3.</source>
        <translation>它的一条边是活动的：在第 %1 行位于 x = %2，三角形从第 %3 列开始。</translation>
    </message>
    <message>
        <source>An edge of it is active: in row %1 it lies at x = %2, and the triangle ends before column %3.</source>
        <translation>它的一条边是活动的：在第 %1 行位于 x = %2，三角形在第 %3 列之前结束。</translation>
    </message>
    <message>
        <source>results alone, above %1 objects</source>
        <translation>物体超过 %1 个，仅记录结果</translation>
    </message>
    <message>
        <source>It is left out with its whole group (objects: %1): %2.</source>
        <translation>它随整组一起被剔除（物体 %1 个）：%2。</translation>
    </message>
    <message>
        <source>What lies in a plane hangs at the plane&apos;s node, in a row &quot;in&quot; with the plane&apos;s name.</source>
        <translation>位于平面内的部分挂在该平面的节点上，列在带平面名称的 &quot;in&quot; 行中。</translation>
    </message>
    <message>
        <source>The paper&apos;s plants are not to be had, and its tables did not survive: here are generated plants of as many pipelines. Of its figures only the conclusion is left, at least 200 % more frames than by triangle.</source>
        <translation>论文的工厂无从获得，其表格也未留存：这里用管线数相同的生成工厂。其数值只留下结论：帧数比按三角形的方法至少多 200 %。</translation>
    </message>
    <message>
        <source>The views are of a walk through the plant at half its height, 30° across as in the paper.</source>
        <translation>各视图取自在工厂一半高度处穿行的漫游，与论文一样水平视场为 30°。</translation>
    </message>
    <message>
        <source>The paper tests every triangle of the plant at every frame. Here small-feature-triangle has the frustum, groups, vector units and every core on its side. Its missed pixels stand beside its time.</source>
        <translation>论文每帧测试工厂的每个三角形。这里 small-feature-triangle 有视锥体、分组、向量单元和所有核心相助。其丢失像素列在时间旁边。</translation>
    </message>
    <message>
        <source>Groups, sizes and draw list are stages of culling: the tests of octrees, those of triangles or components by their size, and the list of what is drawn.</source>
        <translation>分组、尺寸和绘制列表是剔除的各阶段：八叉树的测试、三角形或构件的尺寸测试、待绘制内容的列表。</translation>
    </message>
    <message>
        <source>pipelines</source>
        <translation>管线</translation>
    </message>
    <message>
        <source>Small-feature culling of process plants, by method</source>
        <translation>流程工厂的细节剔除：按方法</translation>
    </message>
    <message>
        <source>Small-feature culling by the number of pipelines</source>
        <translation>细节剔除随管线数量的变化</translation>
    </message>
    <message>
        <source>Culling by visible leaves</source>
        <translation>剔除随可见叶节点的变化</translation>
    </message>
    <message>
        <source>visible leaves</source>
        <translation>可见叶节点</translation>
    </message>
    <message>
        <source>groups, ms</source>
        <translation>分组，ms</translation>
    </message>
    <message>
        <source>Frames per second by pipelines</source>
        <translation>每秒帧数随管线数的变化</translation>
    </message>
    <message>
        <source>Culling by pipelines</source>
        <translation>剔除随管线数的变化</translation>
    </message>
    <message>
        <source>culling, ms</source>
        <translation>剔除，ms</translation>
    </message>
    <message>
        <source>Loss of small-feature culling by its threshold</source>
        <translation>细节剔除的损失随阈值的变化</translation>
    </message>
    <message>
        <source>A threshold of so many pixels is the side of a square. It is k′·tan θ of small-feature and small-feature-triangle, with the paper&apos;s field of view of 30°; small-feature-bounded may lose as many pixels of a group as the square has.</source>
        <translation>以像素计的阈值是一个正方形的边长。对 small-feature 和 small-feature-triangle，它按论文的 30° 视场换算为 k′·tan θ；small-feature-bounded 每组可丢失该正方形所含的像素数。</translation>
    </message>
    <message>
        <source>threshold, px</source>
        <translation>阈值，像素</translation>
    </message>
    <message>
        <source>Speed by threshold: %1</source>
        <translation>速度随阈值的变化：%1</translation>
    </message>
    <message>
        <source>× frustum-octree</source>
        <translation>× frustum-octree</translation>
    </message>
    <message>
        <source>Loss by threshold: %1</source>
        <translation>损失随阈值的变化：%1</translation>
    </message>
    <message>
        <source>sizes, ms</source>
        <translation>尺寸，ms</translation>
    </message>
    <message>
        <source>draw list, ms</source>
        <translation>绘制列表，ms</translation>
    </message>
    <message>
        <source>triangles a pipeline</source>
        <translation>每条管线的三角形</translation>
    </message>
    <message>
        <source>components a pipeline</source>
        <translation>每条管线的构件</translation>
    </message>
    <message>
        <source>frame, ms</source>
        <translation>帧，ms</translation>
    </message>
    <message>
        <source>× frustum-octree [95 %]</source>
        <translation>× frustum-octree [95 %]</translation>
    </message>
    <message>
        <source>paper: × by triangle, at least</source>
        <translation>论文：× 按三角形，至少</translation>
    </message>
    <message>
        <source>× by triangle [95 %]</source>
        <translation>× 按三角形 [95 %]</translation>
    </message>
    <message>
        <source>stated, at most, px</source>
        <translation>声明的最大损失，像素</translation>
    </message>
    <message>
        <source>missed less stated, px</source>
        <translation>丢失减声明，像素</translation>
    </message>
    <message>
        <source>drawing, ms</source>
        <translation>绘制，ms</translation>
    </message>
    <message>
        <source>bytes of the scene</source>
        <translation>场景字节</translation>
    </message>
    <message>
        <source>Making levels of detail</source>
        <translation>正在生成细节层次</translation>
    </message>
    <message>
        <source>%1 polygons are sorted by the distance of their centroids alone. None are compared.</source>
        <translation>%1 个多边形仅按质心的距离排序。彼此不比较。</translation>
    </message>
    <message>
        <source>sort far first, by depth or centroid</source>
        <translation>由远到近排序：按深度或质心</translation>
    </message>
    <message>
        <source>no Q left, or none compared: draw P</source>
        <translation>无剩余 Q 或不比较：绘制 P</translation>
    </message>
    <message>
        <source>Triangle %2 covers no sample and is compared with none: %1 of its area is drawn.</source>
        <translation>三角形 %2 不覆盖任何采样点，不与其他比较：绘制其面积的 %1。</translation>
    </message>
    <message>
        <source>Because of rounding alone triangle %2 still waits for others, and none of them can be cut: %1 of its area is drawn all the same.</source>
        <translation>仅因舍入，三角形 %2 仍在等待其他三角形，而它们都无法切割：仍绘制其面积的 %1。</translation>
    </message>
    <message>
        <source>Of its levels 0 to %1, level %2 moves its surface by at most %3 of %4 pixels.</source>
        <translation>在层次 0 到 %1 中，层次 %2 使其表面最多移动 %3 像素（允许 %4 像素）。</translation>
    </message>
    <message>
        <source>Level %1 would do with %2 pixels; it changes to a coarser level only below %3.</source>
        <translation>层次 %1 只移动 %2 像素，也可使用；但低于 %3 像素时才换用较粗的层次。</translation>
    </message>
    <message>
        <source>The object &quot;%1&quot; has %2 triangles; far away, a coarser level stands for it.</source>
        <translation>物体“%1”有 %2 个三角形；在远处由较粗的层次代替。</translation>
    </message>
    <message>
        <source>k = coarsest: e·f ÷ z ≤ error</source>
        <translation>k = 最粗：e·f ÷ z ≤ error</translation>
    </message>
    <message>
        <source>coarser than last: ≤ (1−h)·error</source>
        <translation>比上次粗：≤ (1−h)·error</translation>
    </message>
    <message>
        <source>draw level k, nearest first</source>
        <translation>绘制层次 k，由近到远</translation>
    </message>
    <message>
        <source>By how many pixels a coarser level may move an object&apos;s surface in the picture.</source>
        <translation>较粗的层次在画面中最多可以使物体表面移动多少像素。</translation>
    </message>
    <message>
        <source>By what share of these pixels a coarser level must stay below them before an object changes to it: against popping.</source>
        <translation>物体换用较粗的层次之前，该层次须比上述像素数低多大的比例：防止跳变。</translation>
    </message>
    <message>
        <source>Level of detail</source>
        <translation>细节层次</translation>
    </message>
    <message>
        <source>Draws far objects with fewer triangles, whose surfaces move by a bounded number of pixels.</source>
        <translation>用较少的三角形绘制远处的物体，其表面移动的像素数有上限。</translation>
    </message>
    <message>
        <source>Outline and details</source>
        <translation>轮廓与细节</translation>
    </message>
    <message>
        <source>&amp;Outline and details</source>
        <translation>轮廓与细节(&amp;O)</translation>
    </message>
    <message>
        <source>Show in the active view the boxes of the components that are always kept, and those of the others by what became of them</source>
        <translation>在活动视图中显示始终保留的构件的包围盒，并按处理结果显示其余构件的包围盒</translation>
    </message>
    <message>
        <source>outline: always kept</source>
        <translation>轮廓：始终保留</translation>
    </message>
    <message>
        <source>The frame before took %1 of %2 ms: now the threshold is %3 and the outline %4 %.</source>
        <translation>上一帧用时 %1 ms（预算 %2 ms）：现在阈值为 %3，轮廓为 %4%。</translation>
    </message>
    <message>
        <source>How many frames per second threshold and outline hold, by the frames&apos; own times; 0: they stay as they are set.</source>
        <translation>阈值和轮廓按各帧自身的用时所保持的每秒帧数；0：保持所设的值。</translation>
    </message>
    <message>
        <source>Of %1 triangles %2 hold no pixel centre.</source>
        <translation>%1 个三角形中有 %2 个不含像素中心。</translation>
    </message>
    <message>
        <source>leave out triangles without a centre</source>
        <translation>剔除不含中心的三角形</translation>
    </message>
    <message>
        <source>Whether triangles without a pixel centre are left out of components that are drawn. It loses nothing.</source>
        <translation>是否从所绘构件中剔除不含像素中心的三角形。不会丢失任何内容。</translation>
    </message>
    <message>
        <source>by row, above %1 steps</source>
        <translation>步骤超过 %1 个，按行</translation>
    </message>
    <message>
        <source>At column %1 the surface in front ends. The first one of those that remain, at depth %2, comes to the front without a comparison.</source>
        <translation>在第 %1 列最前的表面结束。其余表面中的第一个以深度 %2 无需比较即到最前。</translation>
    </message>
    <message>
        <source>At column %1 a surface begins where none is in front, at depth %2: it comes to the front without a comparison.</source>
        <translation>在第 %1 列，一个表面在没有最前表面之处以深度 %2 开始：无需比较即到最前。</translation>
    </message>
    <message>
        <source>At column %1 a surface begins. Its depth %2 is compared with %3 of the one in front: it is farther.</source>
        <translation>在第 %1 列有一个表面开始。其深度 %2 与最前表面的深度 %3 比较：它更远。</translation>
    </message>
    <message>
        <source>At column %1 a surface begins. Its depth %2 is compared with %3 of the one in front: they are equal, and the one that comes first in the scene is in front.</source>
        <translation>在第 %1 列有一个表面开始。其深度 %2 与最前表面的深度 %3 比较：两者相等，场景中靠前的表面在最前。</translation>
    </message>
    <message>
        <source>At column %1 a surface remains where the one in front ended. Its depth %2 is compared with %3 of the one taken so far: it is nearer.</source>
        <translation>在第 %1 列最前的表面结束之处还有一个表面。其深度 %2 与目前选出的表面的深度 %3 比较：它更近。</translation>
    </message>
    <message>
        <source>At column %1 a surface remains where the one in front ended. Its depth %2 is compared with %3 of the one taken so far: it is farther.</source>
        <translation>在第 %1 列最前的表面结束之处还有一个表面。其深度 %2 与目前选出的表面的深度 %3 比较：它更远。</translation>
    </message>
    <message>
        <source>At column %1 a surface remains where the one in front ended. Its depth %2 is compared with %3 of the one taken so far: they are equal, and the one that comes first in the scene is in front.</source>
        <translation>在第 %1 列最前的表面结束之处还有一个表面。其深度 %2 与目前选出的表面的深度 %3 比较：两者相等，场景中靠前的表面在最前。</translation>
    </message>
    <message>
        <source>At column %1 a surface may cross the one in front. Its depth %2 is compared with %3 of that one: it is nearer, and the span is split there.</source>
        <translation>在第 %1 列，一个表面可能与最前的表面相交。其深度 %2 与最前表面的深度 %3 比较：它更近，扫描段在此分开。</translation>
    </message>
    <message>
        <source>At column %1 a surface may cross the one in front. Its depth %2 is compared with %3 of that one: it is farther.</source>
        <translation>在第 %1 列，一个表面可能与最前的表面相交。其深度 %2 与最前表面的深度 %3 比较：它更远。</translation>
    </message>
    <message>
        <source>At column %1 a surface may cross the one in front. Its depth %2 is compared with %3 of that one: they are equal, and the one that comes first in the scene is in front.</source>
        <translation>在第 %1 列，一个表面可能与最前的表面相交。其深度 %2 与最前表面的深度 %3 比较：两者相等，场景中靠前的表面在最前。</translation>
    </message>
    <message>
        <source>begins, none in front: in front</source>
        <translation>开始且前面没有：在最前</translation>
    </message>
    <message>
        <source>A coarser surface of the object is given to OpenGL in place of the triangle.</source>
        <translation>代替该三角形，把物体的较粗表面交给 OpenGL。</translation>
    </message>
    <message>
        <source>promise</source>
        <translation>承诺</translation>
    </message>
    <message>
        <source>beyond snapping, px</source>
        <translation>超出对齐误差，像素</translation>
    </message>
    <message>
        <source>worst view</source>
        <translation>最差视角</translation>
    </message>
    <message>
        <source>go on with the child drawn first</source>
        <translation>走先绘制的子节点</translation>
    </message>
    <message>
        <source>go on with the child drawn last</source>
        <translation>走后绘制的子节点</translation>
    </message>
    <message>
        <source>The system gives no thread for this: %1. Close other programs and try again.</source>
        <translation>系统无法为此创建线程：%1。请关闭其他程序后重试。</translation>
    </message>
    <message>
        <source>The system gives no thread for OpenGL. Close other programs, or allow this one more memory and threads (ulimit).</source>
        <translation>系统无法为 OpenGL 创建线程。请关闭其他程序，或允许本程序使用更多内存和线程（ulimit）。</translation>
    </message>
    <message>
        <source>%1 is no session that can be read: it has more than %2 values.</source>
        <translation>%1 不是可读取的会话：其中的值超过 %2 个。</translation>
    </message>
    <message>
        <source>What the strategy decided cannot be read: %1</source>
        <translation>无法读取策略所作的判定：%1</translation>
    </message>
    <message>
        <source>The views&apos; pictures would have %1 million pixels together, and at most %2 million are possible: choose smaller sizes.</source>
        <translation>各视图的图像合计将有 %1 百万像素，而最多允许 %2 百万像素：请选择较小的尺寸。</translation>
    </message>
    <message>
        <source>There is not enough memory.</source>
        <translation>内存不足。</translation>
    </message>
    <message>
        <source>The reason is not known.</source>
        <translation>原因未知。</translation>
    </message>
    <message>
        <source>This failed, and Cullscope goes on: %1 The session is kept in a file that the next start offers.</source>
        <translation>操作失败，但 Cullscope 会继续运行：%1 会话已保存在文件中，下次启动时可以打开。</translation>
    </message>
    <message>
        <source>This failed, and Cullscope goes on: %1 Save what you need.</source>
        <translation>操作失败，但 Cullscope 会继续运行：%1 请保存所需内容。</translation>
    </message>
    <message>
        <source>Something failed when Cullscope last ran. The session was kept as it was then.</source>
        <translation>Cullscope 上次运行时发生了故障。当时的会话已保留。</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>%1 is no picture that can be read: a progressive JPEG of %2x%3 pixels takes memory for all of them before the first is known. Save it without progressive coding.</source>
        <translation>%1 不是可读取的图像：%2x%3 像素的渐进式 JPEG 在得到第一个像素之前就需要容纳全部像素的内存。请以非渐进方式保存。</translation>
    </message>
    <message>
        <source>%1 is no picture that can be read: its name ends neither in .png, .jpg, .tif nor .exr.</source>
        <translation>%1 不是可读取的图像：其名称不以 .png、.jpg、.tif 或 .exr 结尾。</translation>
    </message>
    <message>
        <source>%1 is no picture that can be read: its name says %2, and it does not begin as such a file does. Give it the ending of what it is.</source>
        <translation>%1 不是可读取的图像：其名称表示 %2 格式，但内容并非以该格式开头。请使用与实际格式相符的扩展名。</translation>
    </message>
    <message>
        <source>%1 has more than %2 poses. Divide the path into several files.</source>
        <translation>%1 中的姿态超过 %2 个。请将路径拆分为多个文件。</translation>
    </message>
    <message>
        <source>%1: a scene of this size needs about %2 MB of memory, more than the %3 MB allowed. Ask for fewer triangles or objects.</source>
        <translation>%1：这种大小的场景约需 %2 MB 内存，超过允许的 %3 MB。请减少三角形或物体的数量。</translation>
    </message>
    <message>
        <source>More than %1 generators stand one inside another. Write the inner scene to a mesh file with cullbench export, and name that file.</source>
        <translation>嵌套的生成器超过 %1 个。请用 cullbench export 将内层场景写入网格文件，并指定该文件。</translation>
    </message>
    <message>
        <source>the program that reads it has ended</source>
        <translation>读取它的程序已结束</translation>
    </message>
    <message>
        <source>&quot;%1&quot; lacks a strategy before or behind a comma. Write A,B without more commas.</source>
        <translation>“%1”的逗号之前或之后缺少策略。请写成 A,B，不要多余的逗号。</translation>
    </message>
    <message>
        <source>Triangles whose sides change by more than a tenth, because their object is too large beside them for floats: %1. Remove what lies far away, or make it an object of its own.</source>
        <translation>因物体相对于三角形过大，取整为 float 后边的变化超过十分之一的三角形：%1。请移除远处的部分，或将其作为单独的物体。</translation>
    </message>
    <message>
        <source>OpenGL cannot be started, for want of memory. Close other programs, or allow this one more (ulimit -v).</source>
        <translation>内存不足，无法启动 OpenGL。请关闭其他程序，或允许本程序使用更多内存（ulimit -v）。</translation>
    </message>
    <message>
        <source>Pictures cannot be written or read, for want of memory. Close other programs, or allow this one more (ulimit -v).</source>
        <translation>内存不足，无法写入或读取图片。请关闭其他程序，或允许本程序使用更多内存（ulimit -v）。</translation>
    </message>
    <message>
        <source>OpenGL cannot be started, for want of threads. Close other programs, or allow this one more (ulimit -u).</source>
        <translation>线程不足，无法启动 OpenGL。请关闭其他程序，或允许本程序使用更多线程（ulimit -u）。</translation>
    </message>
    <message>
        <source>First click the part, then the leaf in which it lies.</source>
        <translation>请先点击部分，再点击它所在的叶子。</translation>
    </message>
    <message>
        <source>%1 is no answer here: the list beside the question has all of them.</source>
        <translation>%1 在这里不是答案：问题旁边的列表列出了所有答案。</translation>
    </message>
    <message>
        <source>Nothing of %1 is drawn: it lies nowhere.</source>
        <translation>%1 没有任何部分被绘制：它不在任何位置。</translation>
    </message>
    <message>
        <source>%1 has several parts: click one of them in a view.</source>
        <translation>%1 有多个部分：请在视图中点击其中一个。</translation>
    </message>
    <message>
        <source>Triangles of the scene are drawn: %1 (ranges: %2)</source>
        <translation>绘制场景的三角形：%1 个（区间：%2 个）</translation>
    </message>
    <message>
        <source>OpenGL is asked about boxes: %1; hit: %2</source>
        <translation>向 OpenGL 询问包围盒：%1 个；命中：%2 个</translation>
    </message>
    <message>
        <source>Triangle %2 is drawn, with node %3.</source>
        <translation>三角形 %2 随节点 %3 绘制。</translation>
    </message>
    <message>
        <source>The tree has the triangle as a whole, drawn where the walk comes to it.</source>
        <translation>树中该三角形是完整的，遍历到达它时绘制。</translation>
    </message>
    <message>
        <source>Triangle %2 covers no sample and is compared with none: it is drawn.</source>
        <translation>三角形 %2 不覆盖任何采样点，不与任何三角形比较：直接绘制。</translation>
    </message>
    <message>
        <source>The centroid of triangle %2, at the distance %3, is the farthest one left: it is drawn without a test.</source>
        <translation>三角形 %2 的质心距离为 %3，是剩余中最远的：不经测试绘制它。</translation>
    </message>
    <message>
        <source>Because of rounding alone triangle %2 still waits for others, and none of them can be cut: it is drawn all the same.</source>
        <translation>仅因舍入，三角形 %2 仍在等待其他三角形，而它们都无法切割：仍然绘制它。</translation>
    </message>
    <message>
        <source>Nothing is left that has to come before: triangle %2 is drawn.</source>
        <translation>没有剩下必须先绘制的：绘制三角形 %2。</translation>
    </message>
    <message>
        <source>No surface reaches here: nothing is compared, and nothing is filled.</source>
        <translation>没有表面到达这里：不比较，也不填充。</translation>
    </message>
    <message>
        <source>Up to this step it is drawn, as a whole or in part; pieces: %1.</source>
        <translation>到这一步为止，它已全部或部分绘制；块数：%1。</translation>
    </message>
    <message>
        <source>Up to this step nothing of it is decided, and nothing of it is drawn.</source>
        <translation>到这一步为止，对它尚未作出任何决定，也未绘制它的任何部分。</translation>
    </message>
    <message>
        <source>Up to this step it is decided to be drawn, and nothing of it is drawn yet.</source>
        <translation>到这一步为止，已决定绘制它，但尚未绘制任何部分。</translation>
    </message>
    <message>
        <source>Depths compared in this row: %1, by a depth buffer: %2; spans filled: %3.</source>
        <translation>此行比较的深度：%1 个，深度缓冲则为 %2 个；填充的扫描段：%3 个。</translation>
    </message>
    <message>
        <source>In row %1 there are active edges: %2; surfaces: %3.</source>
        <translation>第 %1 行的活动边：%2 条；表面：%3 个。</translation>
    </message>
    <message>
        <source>In row %1 there are active edges: %2; surfaces: %3. They lie at x = %4.</source>
        <translation>第 %1 行的活动边：%2 条；表面：%3 个。位于 x = %4。</translation>
    </message>
    <message>
        <source>millimetres that triangles lie away from round surfaces at most; without it, 8 to 32 chords by size</source>
        <translation>三角形与圆形表面的最大距离（毫米）；不给出时，每个圆按大小取 8 至 32 条弦</translation>
    </message>
    <message>
        <source>by-object</source>
        <translation>按物体</translation>
    </message>
    <message>
        <source>× same sides [95 %]</source>
        <translation>× 相同面 [95 %]</translation>
    </message>
    <message>
        <source>× a baseline that draws the same sides</source>
        <translation>× 绘制相同面的基线</translation>
    </message>
    <message>
        <source>N poses in a scene that one stands in: above its floors, outside solids, where much is seen</source>
        <translation>身处其中的场景的 N 个姿态：在地面之上、实体之外、能看到许多东西的地方</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither a camera path file nor a built-in path. Built in: %2.</source>
        <translation>“%1”既不是相机路径文件，也不是内置路径。内置路径：%2。</translation>
    </message>
    <message>
        <source>draw all its triangles</source>
        <translation>绘制它的所有三角形</translation>
    </message>
    <message>
        <source>front sides of each object whose mesh is closed, both sides of the others</source>
        <translation>网格封闭的物体绘制正面，其余绘制两面</translation>
    </message>
    <message>
        <source>baseline, same sides</source>
        <translation>基线，相同面</translation>
    </message>
    <message>
        <source>There is no lesson &quot;%1&quot;: name a lesson&apos;s file, or one of %2.</source>
        <translation>没有课程“%1”：请指定课程文件，或其中之一：%2。</translation>
    </message>
    <message>
        <source>%1 is no lesson that can be read: it has more than %2 bytes.</source>
        <translation>%1 不是可读取的课程：它超过 %2 字节。</translation>
    </message>
    <message>
        <source>%1: a lesson needs a title and at least one line &quot;step&quot;.</source>
        <translation>%1：课程需要标题和至少一行“step”。</translation>
    </message>
    <message>
        <source>%1: the line is no UTF-8: save the file as UTF-8.</source>
        <translation>%1：该行不是 UTF-8：请以 UTF-8 保存文件。</translation>
    </message>
    <message>
        <source>%1: a lesson has at most %2 steps.</source>
        <translation>%1：一课最多有 %2 步。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is no language: write one of %3 before the sentence.</source>
        <translation>%1：“%2”不是语言：请在句子前写 %3 之一。</translation>
    </message>
    <message>
        <source>%1: the sentence is missing.</source>
        <translation>%1：缺少句子。</translation>
    </message>
    <message>
        <source>%1: there is a sentence in &quot;%2&quot; already.</source>
        <translation>%1：已有“%2”的句子。</translation>
    </message>
    <message>
        <source>%1: the value has too many brackets.</source>
        <translation>%1：值的括号太多。</translation>
    </message>
    <message>
        <source>%1: write a field of a session and its value, such as &quot;A.role observer&quot;.</source>
        <translation>%1：请写会话的字段和值，例如“A.role observer”。</translation>
    </message>
    <message>
        <source>%1: write &quot;home&quot;, six numbers (where the camera stands and where it looks), or a camera path and the number of a pose from 0, such as &quot;case-1 3&quot;.</source>
        <translation>%1：请写“home”、六个数（相机的位置和注视点），或相机路径和从 0 开始的姿态编号，例如“case-1 3”。</translation>
    </message>
    <message>
        <source>%1: a session has no field &quot;%2&quot; here.</source>
        <translation>%1：会话在此处没有字段“%2”。</translation>
    </message>
    <message>
        <source>%1: the step has no sentence: add a line &quot;say&quot;.</source>
        <translation>%1：该步没有句子：请添加一行“say”。</translation>
    </message>
    <message>
        <source>The camera path %1 has no pose %2 here: its last one is %3.</source>
        <translation>相机路径 %1 在此没有姿态 %2：最后一个是 %3。</translation>
    </message>
    <message>
        <source>there are 1, 2, 4, 6 or 8 views.</source>
        <translation>视图数为 1、2、4、6 或 8。</translation>
    </message>
    <message>
        <source>The step was added to the lesson %1.</source>
        <translation>已把该步添加到课程 %1。</translation>
    </message>
    <message>
        <source>%1: name a handout&apos;s file that ends in .pdf or .html.</source>
        <translation>%1：讲义文件名应以 .pdf 或 .html 结尾。</translation>
    </message>
    <message>
        <source>What the paper leaves open, reading by reading</source>
        <translation>论文未定之处，逐一解读</translation>
    </message>
    <message>
        <source>Section 2.3 sends objects that no corner ray meets to the contour bands; Appendix 1 only those whose bounding sphere lies inside the frustum. What becomes of one to three rays that miss, how hits are joined, and whether a band that is hidden ends its sector, the paper does not say.</source>
        <translation>第 2.3 节把没有角光线命中的物体交给等高环带；附录 1 只交出包围球在视锥内的物体。有一到三条光线未命中时如何处理、命中点如何连接、被遮挡的带是否终止其扇区，论文未说明。</translation>
    </message>
    <message>
        <source>Where the spherical method works</source>
        <translation>球坐标方法适用之处</translation>
    </message>
    <message>
        <source>Eight directions spread evenly; the distance of the eye is in radii of the bounding sphere, the field of view is vertical, the picture 640 × 480. Of four corner rays that hit, the region between them is drawn; of none, contour bands decide.</source>
        <translation>八个均匀分布的方向；视点的距离以包围球半径为单位，视场角为垂直方向，图像为 640 × 480。四条角光线都命中时绘制其间的区域；都未命中时由等高环带决定。</translation>
    </message>
    <message>
        <source>distance, radii</source>
        <translation>距离，倍半径</translation>
    </message>
    <message>
        <source>field of view, °</source>
        <translation>视场角，°</translation>
    </message>
    <message>
        <source>share of the faces</source>
        <translation>面的占比</translation>
    </message>
    <message>
        <source>rays that hit, of 4</source>
        <translation>命中的光线，共 4 条</translation>
    </message>
    <message>
        <source>The paper&apos;s column is the faces considered. Views are chosen so that spherical considers as many here, in the stated case; faces in the frustum, those on the far side too, and the rays that hit are results. Where a lens has no such view, the nearest one is measured, and its row shows it.</source>
        <translation>论文的这一列是考虑的面数。这里选取的视图使 spherical 在所述情况下考虑同样多的面；视锥内的面（包括背侧的面）和命中的光线是结果。某镜头没有这样的视图时测量最接近的一个，其行会显示出来。</translation>
    </message>
    <message>
        <source>The built-in paths case-1 to case-3 have the paper&apos;s number of faces in the frustum instead.</source>
        <translation>内置路径 case-1 至 case-3 则是视锥内的面数等于论文的数目。</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>Which cases have views that consider the paper&apos;s faces</source>
        <translation>哪些情况存在考虑论文面数的视图</translation>
    </message>
    <message>
        <source>faces wanted</source>
        <translation>所需的面</translation>
    </message>
    <message>
        <source>share wanted</source>
        <translation>所需占比</translation>
    </message>
    <message>
        <source>least share</source>
        <translation>最小占比</translation>
    </message>
    <message>
        <source>most share</source>
        <translation>最大占比</translation>
    </message>
    <message>
        <source>exists</source>
        <translation>存在</translation>
    </message>
    <message>
        <source>else bands: S &gt; S before it?</source>
        <translation>否则看带：S &gt; 之前的 S？</translation>
    </message>
    <message>
        <source>Which objects contour bands decide about.</source>
        <translation>由等高环带决定的物体。</translation>
    </message>
    <message>
        <source>those in the frustum that no corner ray meets (section 2.3)</source>
        <translation>在视锥内且没有角光线命中的物体（第 2.3 节）</translation>
    </message>
    <message>
        <source>those whose sphere lies inside the frustum (Appendix 1)</source>
        <translation>包围球在视锥内的物体（附录 1）</translation>
    </message>
    <message>
        <source>What becomes of a corner ray that meets no triangle.</source>
        <translation>未命中三角形的角光线如何处理。</translation>
    </message>
    <message>
        <source>the point of the sphere or box nearest to it is a corner of the region</source>
        <translation>球或盒上离光线最近的点作为区域的角</translation>
    </message>
    <message>
        <source>the region has no corner there</source>
        <translation>区域在该处没有角</translation>
    </message>
    <message>
        <source>contour bands decide about the object</source>
        <translation>由等高环带决定该物体</translation>
    </message>
    <message>
        <source>Where corner rays begin, and where a missed one takes its point.</source>
        <translation>角光线从何处开始，未命中者在何处取点。</translation>
    </message>
    <message>
        <source>the bounding sphere (sections 2.2 and 2.3)</source>
        <translation>包围球（第 2.2 和 2.3 节）</translation>
    </message>
    <message>
        <source>the bounding box (Appendix 1)</source>
        <translation>包围盒（附录 1）</translation>
    </message>
    <message>
        <source>How the hits are joined to the visible region.</source>
        <translation>命中点如何连接成可见区域。</translation>
    </message>
    <message>
        <source>When a pole lies in the visible region, which is case 1.</source>
        <translation>极点何时位于可见区域内，即情况 1。</translation>
    </message>
    <message>
        <source>when the surface in its direction is within the view</source>
        <translation>其方向上的表面在视野内时</translation>
    </message>
    <message>
        <source>when the outline winds around it</source>
        <translation>轮廓绕其一周时</translation>
    </message>
    <message>
        <source>What a band hides whose S does not exceed the largest before it.</source>
        <translation>S 不超过之前最大值的带遮挡什么。</translation>
    </message>
    <message>
        <source>itself and all bands of its sector behind it</source>
        <translation>自身及其扇区中其后的所有带</translation>
    </message>
    <message>
        <source>itself alone</source>
        <translation>仅自身</translation>
    </message>
    <message>
        <source>Sector %4, band up to α = %3°: S %1 ≤ %2, the largest before it: hidden. The sector&apos;s band up to α = %5° was hidden before and ended it.</source>
        <translation>扇区 %4，至 α = %3° 的环带：S %1 ≤ 之前的最大值 %2：被遮挡。该扇区至 α = %5° 的环带此前已被遮挡并终止了扇区。</translation>
    </message>
    <message>
        <source>Sector %4, band up to α = %3°: its S %1 exceeds %2, the largest before it, but the sector&apos;s band up to α = %5° was hidden and ended it: nothing behind that one is drawn.</source>
        <translation>扇区 %4，至 α = %3° 的环带：其 S %1 大于之前的最大值 %2，但该扇区至 α = %5° 的环带已被遮挡并终止了扇区：其后一概不绘制。</translation>
    </message>
    <message>
        <source>Corner ray %1 enters the bounding box at R = %2.</source>
        <translation>角光线 %1 在 R = %2 处进入包围盒。</translation>
    </message>
    <message>
        <source>Corner ray %1 passes %2 cells of the map and hits nothing; it begins at R = %3.</source>
        <translation>角光线 %1 经过图的 %2 个单元而未命中任何三角形；它从 R = %3 处开始。</translation>
    </message>
    <message>
        <source>Corner ray %1 misses the bounds (cells passed: %2); their point nearest to it is at R = %3.</source>
        <translation>角光线 %1 未触及边界（经过的单元：%2）；边界上离它最近的点在 R = %3 处。</translation>
    </message>
    <message>
        <source>Of the four corner rays %1 meet the object, which is not outside the frustum: contour bands decide about it.</source>
        <translation>四条角光线中有 %1 条命中物体，且物体不在视锥之外：由等高环带决定。</translation>
    </message>
    <message>
        <source>The region between the corners is case %1; boxes around it: %2; triangles in their cells: %3.</source>
        <translation>角之间的区域属于情况 %1；其外的盒：%2；这些单元中的三角形：%3。</translation>
    </message>
    <message>
        <source>not at all: the bounding sphere by its radius</source>
        <translation>不检验盒：以半径检验包围球</translation>
    </message>
    <message>
        <source>Where the six planes come from.</source>
        <translation>六个平面从何而来。</translation>
    </message>
    <message>
        <source>the camera&apos;s basis</source>
        <translation>相机的基</translation>
    </message>
    <message>
        <source>rows of the clip matrix (Gribb &amp; Hartmann 2001)</source>
        <translation>裁剪矩阵的行（Gribb &amp; Hartmann 2001）</translation>
    </message>
    <message>
        <source>corners of the inverse clip cube (Orangelie 2023, mended)</source>
        <translation>逆变换裁剪立方体的角（Orangelie 2023，已修正）</translation>
    </message>
    <message>
        <source>the same as printed, with radius or extent length: loses objects</source>
        <translation>同上但照原文，用半径或延伸向量长度：会丢失物体</translation>
    </message>
    <message>
        <source>1 ÷ (1 − culled), mean of the views</source>
        <translation>1 ÷ (1 − 剔除)，各视点平均</translation>
    </message>
    <message>
        <source>1 ÷ (1 − culled), best view</source>
        <translation>1 ÷ (1 − 剔除)，最佳视点</translation>
    </message>
    <message>
        <source>400 bunnies from 40 viewpoints fitted to the paper&apos;s figures</source>
        <translation>从符合论文数值的 40 个视点看 400 只兔子</translation>
    </message>
    <message>
        <source>The paper&apos;s mean of 12 times, its best of 39.8 times and its 79 % need other viewpoints than a walk: here 9 of 40 see 2.5 % of the bunnies, the others 26 %, so that the means of the culled shares and of what no culling can exceed are the paper&apos;s. Its direct rendering takes the same time at every view; a software OpenGL&apos;s does not.</source>
        <translation>论文的平均 12 倍、最高 39.8 倍和 79 % 需要不同于漫步的视点：这里 40 个视点中 9 个看到 2.5 % 的兔子，其余看到 26 %，使剔除占比的平均值和任何剔除都无法超过的值的平均值与论文相同。论文的直接绘制在每个视点耗时相同；软件 OpenGL 并非如此。</translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation>打开文件夹</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>前</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>下</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>等轴测</translation>
    </message>
    <message>
        <source>Wireframe</source>
        <translation>线框</translation>
    </message>
    <message>
        <source>W&amp;ireframe</source>
        <translation>线框(&amp;I)</translation>
    </message>
    <message>
        <source>Show the edges of the drawn triangles alone; figures stay those of the filled picture</source>
        <translation>只显示所绘三角形的边；数值仍是填充图像的数值</translation>
    </message>
    <message>
        <source>The exact picture shows %1 triangles. They are known beforehand, and in no time of the frame.</source>
        <translation>精确图像显示 %1 个三角形。它们事先已知，不计入帧的任何时间。</translation>
    </message>
    <message>
        <source>Oracle</source>
        <translation>先知</translation>
    </message>
    <message>
        <source>Draws exactly what is visible, known beforehand: what any culling could gain at most.</source>
        <translation>只绘制事先已知可见的部分：任何剔除至多能得到的收益。</translation>
    </message>
    <message>
        <source>What is drawn where any of it is visible.</source>
        <translation>只要有一部分可见就绘制的单位。</translation>
    </message>
    <message>
        <source>the visible triangles</source>
        <translation>可见的三角形</translation>
    </message>
    <message>
        <source>whole objects of which anything is visible</source>
        <translation>有任何部分可见的整个物体</translation>
    </message>
    <message>
        <source>know what is visible (not timed)</source>
        <translation>已知何者可见（不计时）</translation>
    </message>
    <message>
        <source>draw what is visible of it</source>
        <translation>绘制其可见部分</translation>
    </message>
    <message>
        <source>nothing: leave it out</source>
        <translation>没有则剔除</translation>
    </message>
    <message>
        <source>Figure %1</source>
        <translation>图 %1</translation>
    </message>
    <message>
        <source>--pose %1: the path %2 has %3 poses, counted from 0.</source>
        <translation>--pose %1：路径 %2 有 %3 个位姿，从 0 数起。</translation>
    </message>
    <message>
        <source>Figure %1: this frame decided nothing that could be shown.</source>
        <translation>图 %1：这一帧没有可供显示的判定。</translation>
    </message>
    <message>
        <source>There is no Figure %1: the paper has 1 to %2.</source>
        <translation>没有图 %1：论文有图 1 至图 %2。</translation>
    </message>
    <message>
        <source>--step %1: this frame has the steps 0 to %2.</source>
        <translation>--step %1：这一帧有第 0 至第 %2 步。</translation>
    </message>
    <message>
        <source>the step in hand: %1 of %2</source>
        <translation>当前步骤：第 %1 步，共 %2 步</translation>
    </message>
    <message>
        <source>submitted</source>
        <translation>已提交</translation>
    </message>
    <message>
        <source>rest of the object</source>
        <translation>物体的其余部分</translation>
    </message>
    <message>
        <source>bounding sphere</source>
        <translation>包围球</translation>
    </message>
    <message>
        <source>where it enters the sphere</source>
        <translation>进入球处</translation>
    </message>
    <message>
        <source>S of a band that is hidden</source>
        <translation>被遮挡的环带的 S</translation>
    </message>
    <message>
        <source>what is not drawn</source>
        <translation>未绘制的部分</translation>
    </message>
    <message>
        <source>front sides of what is drawn</source>
        <translation>所绘表面的正面</translation>
    </message>
    <message>
        <source>Flow chart of the method</source>
        <translation>方法的流程图</translation>
    </message>
    <message>
        <source>The object and the same in spherical coordinates</source>
        <translation>物体及其球坐标表示</translation>
    </message>
    <message>
        <source>How the intersections of rays are computed</source>
        <translation>光线交点的计算过程</translation>
    </message>
    <message>
        <source>The visible region on the index map, by case</source>
        <translation>索引图上各情形的可见区域</translation>
    </message>
    <message>
        <source>Sampled bands on the object, and their contours on the map</source>
        <translation>物体上的采样环带及其在图上的等高线</translation>
    </message>
    <message>
        <source>S in the sampled bands</source>
        <translation>采样环带中的 S</translation>
    </message>
    <message>
        <source>Sampled bands and what they hide</source>
        <translation>采样环带及其遮挡的部分</translation>
    </message>
    <message>
        <source>The picture without what is hidden, from both sides</source>
        <translation>去除隐藏面后的画面，正反两面</translation>
    </message>
    <message>
        <source>There is no font for the picture&apos;s letters: install the package fonts-noto-cjk or fonts-dejavu-core, or write an .svg file, whose letters its viewer draws.</source>
        <translation>没有可用于图片文字的字体：请安装软件包 fonts-noto-cjk 或 fonts-dejavu-core，或写成 .svg 文件，其文字由查看程序绘制。</translation>
    </message>
    <message>
        <source>Ghost of the whole objects</source>
        <translation>整个物体的虚影</translation>
    </message>
    <message>
        <source>&amp;Ghost of the whole objects</source>
        <translation>整个物体的虚影(&amp;G)</translation>
    </message>
    <message>
        <source>Show all objects as ghosts around what was drawn of them in the active view</source>
        <translation>在活动视图中，在已绘制部分的周围以虚影显示所有物体</translation>
    </message>
    <message>
        <source>Back sides in orange</source>
        <translation>背面用橙色</translation>
    </message>
    <message>
        <source>Back si&amp;des in orange</source>
        <translation>背面用橙色(&amp;D)</translation>
    </message>
    <message>
        <source>Show the back sides of surfaces in orange in the active view: what is hollow is not taken for a body</source>
        <translation>在活动视图中用橙色显示表面的背面：空壳不会被误认为实体</translation>
    </message>
    <message>
        <source>Vertices to spherical coordinates R, θ, φ</source>
        <translation>顶点转为球坐标 R、θ、φ</translation>
    </message>
    <message>
        <source>Centroid map, triangle index map, memory access map</source>
        <translation>质心图、三角形索引图、内存访问图</translation>
    </message>
    <message>
        <source>Bounding sphere and frustum</source>
        <translation>包围球与视锥体</translation>
    </message>
    <message>
        <source>Nothing is drawn</source>
        <translation>什么都不绘制</translation>
    </message>
    <message>
        <source>Inside the frustum?</source>
        <translation>在视锥体内？</translation>
    </message>
    <message>
        <source>Search of the triangle index map for the triangles hit</source>
        <translation>在三角形索引图中搜索命中的三角形</translation>
    </message>
    <message>
        <source>Does a ray meet the object?</source>
        <translation>有光线与物体相交？</translation>
    </message>
    <message>
        <source>Visible region on the map: case 1, 2 or 3</source>
        <translation>图上的可见区域：情形 1、2 或 3</translation>
    </message>
    <message>
        <source>Boxes around it, ranges of the memory access map</source>
        <translation>其包围盒，内存访问图的区间</translation>
    </message>
    <message>
        <source>Graphics pipeline</source>
        <translation>图形管线</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>外部</translation>
    </message>
    <message>
        <source>inside, or cut by a plane</source>
        <translation>内部，或被平面切割</translation>
    </message>
    <message>
        <source>Show the contour bands of spherical strategies on the objects&apos; bounding spheres in the active view</source>
        <translation>在活动视图中，在物体的包围球上显示球坐标策略的等高环带</translation>
    </message>
    <message>
        <source>S of the contour bands</source>
        <translation>等高环带的 S</translation>
    </message>
    <message>
        <source>S of the contour ba&amp;nds</source>
        <translation>等高环带的 S(&amp;N)</translation>
    </message>
    <message>
        <source>Show S of each contour band of one sector in the active view: a line from the axis to the surface that it is measured at, dashed where the band is hidden</source>
        <translation>在活动视图中显示一个扇区内各等高环带的 S：从轴到测得它的表面的线，环带被遮挡处为虚线</translation>
    </message>
    <message>
        <source>write x, y, z or view, and a share, as in &quot;x:0.5&quot;.</source>
        <translation>请写 x、y、z 或 view，以及一个比例，例如 &quot;x:0.5&quot;。</translation>
    </message>
    <message>
        <source>The height of a parallel view must be a number above 0, not %1.</source>
        <translation>平行视图的高度必须是大于 0 的数，而不是 %1。</translation>
    </message>
    <message>
        <source>%1: &quot;projection&quot; must be &quot;perspective&quot; or &quot;parallel&quot;.</source>
        <translation>%1：&quot;projection&quot; 必须是 &quot;perspective&quot; 或 &quot;parallel&quot;。</translation>
    </message>
    <message>
        <source>%1: a parallel projection needs its &quot;height&quot;, in scene units.</source>
        <translation>%1：平行投影需要以场景单位给出的 &quot;height&quot;。</translation>
    </message>
    <message>
        <source>%1 needs the place of an eye, and a parallel view has none: every triangle is drawn.</source>
        <translation>%1 需要视点的位置，而平行视图没有：绘制所有三角形。</translation>
    </message>
    <message>
        <source>hit records, mean</source>
        <translation>命中记录，平均</translation>
    </message>
    <message>
        <source>overflows of the hit buffer</source>
        <translation>命中缓冲区溢出</translation>
    </message>
    <message>
        <source>a vertex: position, normal; a face: 3 indices</source>
        <translation>每顶点：位置、法线；每面：3 个索引</translation>
    </message>
    <message>
        <source>a face: 3 corners with position and normal</source>
        <translation>每面：3 个带位置和法线的角点</translation>
    </message>
    <message>
        <source>a face: 3 corners with position, 1 normal, 3 indices</source>
        <translation>每面：3 个带位置的角点、1 条法线、3 个索引</translation>
    </message>
    <message>
        <source>the paper&apos;s formula: 4 floats a face</source>
        <translation>论文的公式：每面 4 个浮点数</translation>
    </message>
    <message>
        <source>R, θ, φ in floats a face; 4 numbers a cell</source>
        <translation>每面浮点数 R、θ、φ；每格 4 个数</translation>
    </message>
    <message>
        <source>R, θ, φ and index a face; 4 numbers a cell</source>
        <translation>每面 R、θ、φ 和索引；每格 4 个数</translation>
    </message>
    <message>
        <source>R, θ, φ in doubles a face; 4 numbers a cell</source>
        <translation>每面双精度 R、θ、φ；每格 4 个数</translation>
    </message>
    <message>
        <source>index and R an entry</source>
        <translation>每条目：索引和 R</translation>
    </message>
    <message>
        <source>index and R an entry; start and count a cell</source>
        <translation>每条目：索引和 R；每格：起点和数目</translation>
    </message>
    <message>
        <source>index, R and a link to the next an entry</source>
        <translation>每条目：索引、R 和指向下一条目的链接</translation>
    </message>
    <message>
        <source>index an entry; start, nearest and farthest R a cell, as here</source>
        <translation>每条目：索引；每格：起点、最近和最远的 R，与此处相同</translation>
    </message>
    <message>
        <source>the paper&apos;s formula: 4 integers a cell</source>
        <translation>论文的公式：每格 4 个整数</translation>
    </message>
    <message>
        <source>start and count a cell</source>
        <translation>每格：起点和数目</translation>
    </message>
    <message>
        <source>What the sizes in Table 1 can be made of</source>
        <translation>表 1 的大小可由什么构成</translation>
    </message>
    <message>
        <source>The paper gives about 10, 4.3, 6.7 and 0.51 MB, and formulas that give other sizes; 3.46 MB stands in its table without a word. Each row is a layout that fits its text, with its size here.</source>
        <translation>论文给出约 10、4.3、6.7 和 0.51 MB，而其公式给出别的大小；3.46 MB 在表中没有说明。每一行是一种符合其正文的布局及其在此处的大小。</translation>
    </message>
    <message>
        <source>layout</source>
        <translation>布局</translation>
    </message>
    <message>
        <source>here: MiB</source>
        <translation>此处：MiB</translation>
    </message>
    <message>
        <source>off in MB, %</source>
        <translation>以 MB 计的偏差，%</translation>
    </message>
    <message>
        <source>off in MiB, %</source>
        <translation>以 MiB 计的偏差，%</translation>
    </message>
    <message>
        <source>bytes a face</source>
        <translation>每面字节数</translation>
    </message>
    <message>
        <source>region between rays, share of the views</source>
        <translation>光线间区域，占视角的比例</translation>
    </message>
    <message>
        <source>Views in which the region between rays is drawn, %</source>
        <translation>绘制光线间区域的视角，%</translation>
    </message>
    <message>
        <source>Corner rays that hit, of 4</source>
        <translation>命中的角光线，共 4 条</translation>
    </message>
    <message>
        <source>Faces considered, %</source>
        <translation>所考虑的面，%</translation>
    </message>
    <message>
        <source>Lost pixels, %</source>
        <translation>丢失的像素，%</translation>
    </message>
    <message>
        <source>Speed, × all</source>
        <translation>速度，× all</translation>
    </message>
    <message>
        <source>one</source>
        <translation>同一</translation>
    </message>
    <message>
        <source>different</source>
        <translation>不同</translation>
    </message>
    <message>
        <source>views of the windows</source>
        <translation>窗口的视角</translation>
    </message>
    <message>
        <source>The paper does not say whether its windows show one view or different ones: both are measured. Different ones are spread evenly over a case&apos;s twelve views.</source>
        <translation>论文没有说明各窗口显示同一视角还是不同视角：两者都测量。不同的视角均匀分布于一个情形的十二个视角。</translation>
    </message>
    <message>
        <source>Boxes are drawn in OpenGL&apos;s selection mode: %1; hit records: %2; the hit buffer of %3 words overflowed before: %4</source>
        <translation>以 OpenGL 的选择模式绘制的包围盒：%1；命中记录：%2；%3 个字的命中缓冲区此前溢出次数：%4</translation>
    </message>
    <message>
        <source>OpenGL was asked about the box, grown by %1: it was hit, at depths from %2 to %3.</source>
        <translation>就放大 %1 的包围盒询问了 OpenGL：命中，深度为 %2 至 %3。</translation>
    </message>
    <message>
        <source>The mesh&apos;s axis to which the map&apos;s poles belong.</source>
        <translation>映射图两极所在的网格轴。</translation>
    </message>
    <message>
        <source>z, as in equation (1)</source>
        <translation>z，如式 (1)</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y, which points up in many models</source>
        <translation>y，在许多模型中朝上</translation>
    </message>
    <message>
        <source>The point from which R and the directions are measured.</source>
        <translation>测量 R 和方向的起点。</translation>
    </message>
    <message>
        <source>the centre of the bounding sphere</source>
        <translation>包围球的中心</translation>
    </message>
    <message>
        <source>the middle of the bounding box</source>
        <translation>包围盒的中点</translation>
    </message>
    <message>
        <source>the centroid of the surface</source>
        <translation>表面的质心</translation>
    </message>
    <message>
        <source>%1 was written by another version: its blocks are not those of this one.</source>
        <translation>%1 由另一版本写成：其分块与本版本不同。</translation>
    </message>
    <message>
        <source>%1 is no state of cullbench certify that can be read. Name another file, or remove it and begin anew.</source>
        <translation>%1 不是可读取的 cullbench certify 状态文件。请指定其他文件，或将其删除后重新开始。</translation>
    </message>
    <message>
        <source>There is nothing to merge: name state files.</source>
        <translation>没有可合并的内容：请指定状态文件。</translation>
    </message>
    <message>
        <source>The state files are of different runs: %1 with seed %2 and %3 blocks, and %4 with seed %5 and %6 blocks.</source>
        <translation>状态文件属于不同的运行：一个是 %1，种子 %2，%3 个分块；另一个是 %4，种子 %5，%6 个分块。</translation>
    </message>
    <message>
        <source>Two of the state files tried block %1: each shard is to be merged once.</source>
        <translation>有两个状态文件都试过分块 %1：每个分片只应合并一次。</translation>
    </message>
    <message>
        <source>%1 has the state of another run, of %2 with seed %3: name another file, or remove it.</source>
        <translation>%1 中是另一次运行（%2，种子 %3）的状态：请指定其他文件，或删除它。</translation>
    </message>
    <message>
        <source>certifying</source>
        <translation>正在验证</translation>
    </message>
    <message>
        <source>strategies that promise to lose nothing lose nothing</source>
        <translation>承诺不丢失的策略什么也不丢失</translation>
    </message>
    <message>
        <source>ends, or stops with a sentence; areas are kept and nothing is lost</source>
        <translation>正常结束，或以一句说明停止；面积保持，无丢失</translation>
    </message>
    <message>
        <source>A sphere beside a corner of the view that passes every plane test</source>
        <translation>位于视野角旁、通过所有平面测试的球</translation>
    </message>
    <message>
        <source>planes do not tell it apart, the exact test does</source>
        <translation>平面无法区分，精确测试可以</translation>
    </message>
    <message>
        <source>A box beside the view that passes every p-vertex test</source>
        <translation>位于视野旁、通过所有 p 顶点测试的盒</translation>
    </message>
    <message>
        <source>A flat box above a plane</source>
        <translation>平面上方的扁盒</translation>
    </message>
    <message>
        <source>its extent&apos;s length keeps it, its p-vertex does not</source>
        <translation>按范围长度会保留它，按 p 顶点则剔除</translation>
    </message>
    <message>
        <source>A sphere at a plane ten million from the origin</source>
        <translation>距原点一千万处平面上的球</translation>
    </message>
    <message>
        <source>visible; floats say that it is not</source>
        <translation>可见；单精度浮点数会说不可见</translation>
    </message>
    <message>
        <source>A file with NaN, infinite numbers, faces without area and corners that are not there</source>
        <translation>含 NaN、无穷大、无面积的面和不存在的角点的文件</translation>
    </message>
    <message>
        <source>counted and left out; the other faces stay</source>
        <translation>计数后剔除；其余面保留</translation>
    </message>
    <message>
        <source>A triangle over the seam of a map of directions</source>
        <translation>跨越方向图接缝的三角形</translation>
    </message>
    <message>
        <source>columns 359 and 0 only</source>
        <translation>仅第 359 列和第 0 列</translation>
    </message>
    <message>
        <source>A triangle around the pole of a map of directions</source>
        <translation>环绕方向图极点的三角形</translation>
    </message>
    <message>
        <source>every column of the polar row</source>
        <translation>极行的每一列</translation>
    </message>
    <message>
        <source>Azimuths in other quadrants than the first</source>
        <translation>第一象限以外的方位角</translation>
    </message>
    <message>
        <source>225 and 90 degrees</source>
        <translation>225 度和 90 度</translation>
    </message>
    <message>
        <source>An azimuth that rounds to a whole turn</source>
        <translation>舍入为一整圈的方位角</translation>
    </message>
    <message>
        <source>column 359 or 0, never 360</source>
        <translation>第 359 列或第 0 列，绝非 360</translation>
    </message>
    <message>
        <source>A zenith angle of a hundred-millionth of a degree</source>
        <translation>约一亿分之一度的天顶角</translation>
    </message>
    <message>
        <source>kept; an arc cosine gives 0</source>
        <translation>得以保留；反余弦会得到 0</translation>
    </message>
    <message>
        <source>A corner or a centroid exactly at the centre</source>
        <translation>恰好位于中心的角点或重心</translation>
    </message>
    <message>
        <source>finite, and a candidate in every direction</source>
        <translation>有限，并且在每个方向上都是候选</translation>
    </message>
    <message>
        <source>A camera at three radii at every latitude</source>
        <translation>在各纬度上位于三倍半径处的相机</translation>
    </message>
    <message>
        <source>A camera on the polar axis</source>
        <translation>位于极轴上的相机</translation>
    </message>
    <message>
        <source>A sphere in view that all four corner rays miss</source>
        <translation>四条角光线都未命中的可见球</translation>
    </message>
    <message>
        <source>A ray that enters the bounding sphere far from where it hits</source>
        <translation>进入包围球处远离命中处的光线</translation>
    </message>
    <message>
        <source>the walk reaches the surface, 37 degrees away</source>
        <translation>搜索能到达相隔 37 度的表面</translation>
    </message>
    <message>
        <source>A tilted torus from afar</source>
        <translation>从远处看的倾斜圆环</translation>
    </message>
    <message>
        <source>A thick bowl seen into its opening</source>
        <translation>朝开口看去的厚碗</translation>
    </message>
    <message>
        <source>A camera inside the bounding sphere, and exactly at its centre</source>
        <translation>位于包围球内以及恰在其中心的相机</translation>
    </message>
    <message>
        <source>Two surfaces a hundredth apart, near 0.01 and far a million</source>
        <translation>相距百分之一的两个表面，近 0.01、远一百万</translation>
    </message>
    <message>
        <source>The same on a depth buffer of 24 bits, in both drawing orders</source>
        <translation>同样情形用 24 位深度缓冲，以两种绘制次序</translation>
    </message>
    <message>
        <source>wrong in one of them: floats are right in both</source>
        <translation>其中一种会错：浮点深度两种都对</translation>
    </message>
    <message>
        <source>A body of size 1e-18</source>
        <translation>尺寸为 1e-18 的物体</translation>
    </message>
    <message>
        <source>A body of size 1e18</source>
        <translation>尺寸为 1e18 的物体</translation>
    </message>
    <message>
        <source>Bodies of both sizes in one scene</source>
        <translation>同一场景中两种尺寸的物体</translation>
    </message>
    <message>
        <source>A scene moved by ten million, through its transforms and through its coordinates</source>
        <translation>通过变换以及通过坐标移动一千万的场景</translation>
    </message>
    <message>
        <source>the same objects, the same picture away from edges, and nothing lost</source>
        <translation>物体相同，边缘以外画面相同，且无丢失</translation>
    </message>
    <message>
        <source>A box around the eye, and one that reaches beyond the far plane</source>
        <translation>包围视点的盒，以及超出远平面的盒</translation>
    </message>
    <message>
        <source>not outside, and nothing lost</source>
        <translation>不在外部，且无丢失</translation>
    </message>
    <message>
        <source>A field of view of a hundredth of a degree</source>
        <translation>百分之一度的视场角</translation>
    </message>
    <message>
        <source>A field of view of 179 degrees</source>
        <translation>179 度的视场角</translation>
    </message>
    <message>
        <source>An eye that turns by 180 degrees a second, and answers that come late</source>
        <translation>每秒转动 180 度的视点，以及迟到的答案</translation>
    </message>
    <message>
        <source>without latency nothing is lost; with it the loss is seen</source>
        <translation>无延迟时无丢失；有延迟时可见丢失</translation>
    </message>
    <message>
        <source>Selection mode with 400 names in a buffer that is four words too small</source>
        <translation>选择模式：400 个名称放入少四个字的缓冲区</translation>
    </message>
    <message>
        <source>the overflow is seen, and tried again: 400 hits</source>
        <translation>发现溢出并重试：400 次命中</translation>
    </message>
    <message>
        <source>An object&apos;s box around the eye and the far plane, and an eye just outside of it</source>
        <translation>包围视点和远平面的物体盒，以及恰在其外的视点</translation>
    </message>
    <message>
        <source>Three bars that overlap each other in a cycle</source>
        <translation>循环相互遮挡的三根条</translation>
    </message>
    <message>
        <source>cut at least once and right at every overlap; centroids alone are not</source>
        <translation>至少切割一次且每处重叠都正确；仅用重心则不正确</translation>
    </message>
    <message>
        <source>Edges through pixel centres: a triangle and its complement</source>
        <translation>穿过像素中心的边：三角形及其补形</translation>
    </message>
    <message>
        <source>10 and 6 pixels, 16 together, none twice</source>
        <translation>10 和 6 个像素，合计 16，无重复</translation>
    </message>
    <message>
        <source>40,000 abutting parts just below the threshold of small features</source>
        <translation>40,000 个相接、略低于细节阈值的部件</translation>
    </message>
    <message>
        <source>as published a hole opens; with a bound it does not</source>
        <translation>按论文会出现空洞；有界限时不会</translation>
    </message>
    <message>
        <source>Mirrored and flattened bodies</source>
        <translation>镜像和压扁的物体</translation>
    </message>
    <message>
        <source>Ten thousand polygons in one plane in a BSP tree</source>
        <translation>BSP 树中同一平面的一万个多边形</translation>
    </message>
    <message>
        <source>Polygons that share every edge in a BSP tree</source>
        <translation>BSP 树中共享每条边的多边形</translation>
    </message>
    <message>
        <source>Slivers a billion times as long as wide in a BSP tree</source>
        <translation>BSP 树中长为宽十亿倍的狭条</translation>
    </message>
    <message>
        <source>Ten thousand random triangles in a BSP tree</source>
        <translation>BSP 树中的一万个随机三角形</translation>
    </message>
    <message>
        <source>Two surfaces one rounding of a float apart</source>
        <translation>相差一个浮点舍入的两个表面</translation>
    </message>
    <message>
        <source>unresolved, and not counted as missed</source>
        <translation>无法分辨，且不计为缺失</translation>
    </message>
    <message>
        <source>Triangles through the near plane with every corner outside the view</source>
        <translation>穿过近平面、所有角点都在视野外的三角形</translation>
    </message>
    <message>
        <source>An empty object and triangles without area beside a square</source>
        <translation>正方形旁的空物体和无面积三角形</translation>
    </message>
    <message>
        <source>There is no case &quot;%1&quot;. Known: their numbers, or %2.</source>
        <translation>没有案例“%1”。已知：其编号，或 %2。</translation>
    </message>
    <message>
        <source>all %1 findings are right</source>
        <translation>全部 %1 项结果正确</translation>
    </message>
    <message>
        <source>cut by a plane: not told apart</source>
        <translation>被平面切过：无法区分</translation>
    </message>
    <message>
        <source>not outside</source>
        <translation>不在外部</translation>
    </message>
    <message>
        <source>separate</source>
        <translation>分离</translation>
    </message>
    <message>
        <source>not separate</source>
        <translation>不分离</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>空</translation>
    </message>
    <message>
        <source>no pixel lost where it promises so</source>
        <translation>在其承诺之处无像素丢失</translation>
    </message>
    <message>
        <source>its loss is measured</source>
        <translation>测量其丢失</translation>
    </message>
    <message>
        <source>%1 of %2 pixels lost</source>
        <translation>%2 个像素中丢失 %1 个</translation>
    </message>
    <message>
        <source>no pixel lost, or a sentence that says why it does not serve the scene</source>
        <translation>无像素丢失，或以一句话说明为何不适用于该场景</translation>
    </message>
    <message>
        <source>a loss that is seen</source>
        <translation>可见的丢失</translation>
    </message>
    <message>
        <source>not tried</source>
        <translation>未尝试</translation>
    </message>
    <message>
        <source>more than %1 % of the pixels lost, and that is seen</source>
        <translation>丢失超过 %1 % 的像素，并被发现</translation>
    </message>
    <message>
        <source>a surface in the picture</source>
        <translation>画面中有表面</translation>
    </message>
    <message>
        <source>an empty picture</source>
        <translation>空画面</translation>
    </message>
    <message>
        <source>%1 pixels covered</source>
        <translation>覆盖 %1 个像素</translation>
    </message>
    <message>
        <source>the nearer surface is seen</source>
        <translation>看到较近的表面</translation>
    </message>
    <message>
        <source>the farther surface is seen</source>
        <translation>看到较远的表面</translation>
    </message>
    <message>
        <source>the picture of the scene at the origin</source>
        <translation>位于原点的场景的画面</translation>
    </message>
    <message>
        <source>%1 pixels differ beyond the raster&apos;s snapping</source>
        <translation>%1 个像素的差异超出光栅对齐</translation>
    </message>
    <message>
        <source>the objects of the scene at the origin</source>
        <translation>位于原点的场景的物体</translation>
    </message>
    <message>
        <source>%1 views with other objects</source>
        <translation>%1 个视点的物体不同</translation>
    </message>
    <message>
        <source>400 hits</source>
        <translation>400 次命中</translation>
    </message>
    <message>
        <source>this OpenGL has no selection mode</source>
        <translation>此 OpenGL 没有选择模式</translation>
    </message>
    <message>
        <source>more than %1</source>
        <translation>多于 %1</translation>
    </message>
    <message>
        <source>areas kept to 1e-9</source>
        <translation>面积保持到 1e-9</translation>
    </message>
    <message>
        <source>%1 polygons, areas kept to %2</source>
        <translation>%1 个多边形，面积保持到 %2</translation>
    </message>
    <message>
        <source>unresolved</source>
        <translation>无法分辨</translation>
    </message>
    <message>
        <source>missed</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>another difference</source>
        <translation>其他差异</translation>
    </message>
    <message>
        <source>The drawn sets have %1 poses, and the camera path %2: give one set for each pose.</source>
        <translation>绘制集有 %1 个姿态，而相机路径有 %2 个：请为每个姿态给出一个集合。</translation>
    </message>
    <message>
        <source>judging</source>
        <translation>正在评判</translation>
    </message>
    <message>
        <source>No culling: nothing is left out, and %1 objects in view are drawn in vain.</source>
        <translation>无剔除：没有剔除任何物体，视野内有 %1 个物体被徒劳绘制。</translation>
    </message>
    <message>
        <source>View-frustum culling: all %1 objects that are left out lie outside the view, nothing that is seen is missing, and %2 objects in view are drawn though they are hidden.</source>
        <translation>视锥剔除：剔除的 %1 个物体都在视野外，可见的没有缺失，视野内有 %2 个物体虽被遮挡仍被绘制。</translation>
    </message>
    <message>
        <source>Occlusion culling: what is left out in view is not seen, and nothing that is seen is missing.</source>
        <translation>遮挡剔除：视野内剔除的都不可见，可见的没有缺失。</translation>
    </message>
    <message>
        <source>Something that is seen is missing: %1 times a visible object is not drawn whole.</source>
        <translation>可见的内容有缺失：有 %1 次可见物体未被完整绘制。</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made: %2.</source>
        <translation>无法创建文件夹 %1：%2。</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>正在写入</translation>
    </message>
    <message>
        <source>the poses that the scene gives, as those of the gallery do; of others one that shows it all</source>
        <translation>场景给出的姿态，如图库场景；其他场景为显示全部的一个姿态</translation>
    </message>
    <message>
        <source>%1: drawn sets need a list &quot;poses&quot; with at least one pose.</source>
        <translation>%1：绘制集需要至少含一个姿态的列表“poses”。</translation>
    </message>
    <message>
        <source>%1: some poses have a camera and some have none. Give every pose one, or none.</source>
        <translation>%1：有的姿态有相机，有的没有。请全部给出，或全部不给。</translation>
    </message>
    <message>
        <source>%1: pose %2 needs a list &quot;objects&quot; or a list &quot;triangles&quot; of what is drawn.</source>
        <translation>%1：姿态 %2 需要列出所绘内容的列表“objects”或“triangles”。</translation>
    </message>
    <message>
        <source>%1: pose %2: %3 names nothing in this scene of %4 triangles in %5 objects. Numbers count from 0.</source>
        <translation>%1：姿态 %2：在这个有 %4 个三角形、%5 个物体的场景中，%3 不指任何内容。编号从 0 起。</translation>
    </message>
    <message>
        <source>%1 is not JSON: it breaks off at byte %2. Drawn sets have a list &quot;poses&quot;.</source>
        <translation>%1 不是 JSON：在第 %2 字节处中断。绘制集有列表“poses”。</translation>
    </message>
    <message>
        <source>%1 holds a number that is too large.</source>
        <translation>%1 含有过大的数。</translation>
    </message>
    <message>
        <source>a sphere beside a corner of the view that no single plane of it tells apart</source>
        <translation>视野角旁的球，任何单个平面都无法区分</translation>
    </message>
    <message>
        <source>a box beside the view that no single plane of it tells apart</source>
        <translation>视野旁的盒，任何单个平面都无法区分</translation>
    </message>
    <message>
        <source>a corner and a centroid exactly at the centre of the bounding sphere</source>
        <translation>恰在包围球中心的角点和重心</translation>
    </message>
    <message>
        <source>a sphere from three radii, at latitudes from the equator to the pole</source>
        <translation>从赤道到极点各纬度、三倍半径处看的球</translation>
    </message>
    <message>
        <source>a sphere from above and below its poles</source>
        <translation>从两极上方和下方看的球</translation>
    </message>
    <message>
        <source>a sphere half in view that all four corner rays miss</source>
        <translation>半在视野中、四条角光线都未命中的球</translation>
    </message>
    <message>
        <source>a ball of half the radius of its bounding sphere: rays enter far from where they hit</source>
        <translation>半径为包围球一半的球：光线进入处远离命中处</translation>
    </message>
    <message>
        <source>a torus tilted by 60 degrees, from afar</source>
        <translation>倾斜 60 度的圆环，从远处看</translation>
    </message>
    <message>
        <source>a thick bowl seen into its opening</source>
        <translation>朝开口看去的厚碗</translation>
    </message>
    <message>
        <source>a star-shaped body from inside and from its very centre</source>
        <translation>从内部及正中心看的星形体</translation>
    </message>
    <message>
        <source>two squares a hundredth apart at distance 1000, near 0.01 and far a million</source>
        <translation>距离 1000 处相距百分之一的两个正方形，近 0.01、远一百万</translation>
    </message>
    <message>
        <source>a body of size 1e-18</source>
        <translation>尺寸为 1e-18 的物体</translation>
    </message>
    <message>
        <source>a body of size 1e18</source>
        <translation>尺寸为 1e18 的物体</translation>
    </message>
    <message>
        <source>bodies of sizes 1e-18 and 1e18 in one scene</source>
        <translation>同一场景中尺寸为 1e-18 和 1e18 的物体</translation>
    </message>
    <message>
        <source>four bodies at the origin, as those of case 21 that are moved</source>
        <translation>位于原点的四个物体，与案例 21 中被移动的相同</translation>
    </message>
    <message>
        <source>four bodies moved by ten million through their transforms</source>
        <translation>通过变换移动一千万的四个物体</translation>
    </message>
    <message>
        <source>four bodies moved by ten million through their coordinates</source>
        <translation>通过坐标移动一千万的四个物体</translation>
    </message>
    <message>
        <source>a box around the eye, and one that reaches beyond the far plane on all sides</source>
        <translation>包围视点的盒，以及四面都超出远平面的盒</translation>
    </message>
    <message>
        <source>a body in a field of view of a hundredth of a degree</source>
        <translation>百分之一度视场角中的物体</translation>
    </message>
    <message>
        <source>a body in a field of view of 179 degrees</source>
        <translation>179 度视场角中的物体</translation>
    </message>
    <message>
        <source>walls with bodies behind them, from an eye that turns by 180 degrees a second</source>
        <translation>从每秒转动 180 度的视点看，背后有物体的墙</translation>
    </message>
    <message>
        <source>an object whose box holds the eye and the far plane</source>
        <translation>其盒包含视点和远平面的物体</translation>
    </message>
    <message>
        <source>three bars that overlap each other in a cycle</source>
        <translation>循环相互遮挡的三根条</translation>
    </message>
    <message>
        <source>a triangle and its complement whose edges pass through pixel centres of an 8x8 picture</source>
        <translation>三角形及其补形，其边穿过 8x8 画面的像素中心</translation>
    </message>
    <message>
        <source>200 by 200 abutting parts just below the threshold of small features</source>
        <translation>200 乘 200 个相接、略低于细节阈值的部件</translation>
    </message>
    <message>
        <source>a mirrored body and a flattened one</source>
        <translation>一个镜像物体和一个压扁物体</translation>
    </message>
    <message>
        <source>ten thousand triangles in one plane</source>
        <translation>同一平面的一万个三角形</translation>
    </message>
    <message>
        <source>triangles that share their edges with many others</source>
        <translation>与许多其他三角形共享边的三角形</translation>
    </message>
    <message>
        <source>slivers a billion times as long as wide, among random triangles</source>
        <translation>随机三角形之间长为宽十亿倍的狭条</translation>
    </message>
    <message>
        <source>ten thousand random triangles that fill a cube</source>
        <translation>充满立方体的一万个随机三角形</translation>
    </message>
    <message>
        <source>two squares one rounding of a float apart</source>
        <translation>相差一个浮点舍入的两个正方形</translation>
    </message>
    <message>
        <source>triangles through the near plane with every corner outside the view</source>
        <translation>穿过近平面、所有角点都在视野外的三角形</translation>
    </message>
    <message>
        <source>an empty object and triangles without area beside a square</source>
        <translation>正方形旁的空物体和无面积三角形</translation>
    </message>
    <message>
        <source>%1 has no cameras beside its sets, by which a view would find its own: give every pose eye, target and up.</source>
        <translation>%1 的集合旁没有相机，视图无法据此找到自己的集合：请为每个姿态给出 eye、target 和 up。</translation>
    </message>
    <message>
        <source>The camera of pose %1 of the file is the nearest one: its set is drawn.</source>
        <translation>文件中姿态 %1 的相机最近：绘制它的集合。</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Draws what another program says that it draws at the nearest pose, from a file.</source>
        <translation>从文件读取并绘制另一程序声称在最近姿态所绘制的内容。</translation>
    </message>
    <message>
        <source>File of drawn sets with their cameras (JSON); without one everything is drawn.</source>
        <translation>带相机的绘制集文件（JSON）；没有则绘制全部。</translation>
    </message>
    <message>
        <source>take the pose with the nearest camera</source>
        <translation>取相机最近的姿态</translation>
    </message>
    <message>
        <source>draw what the file has of it</source>
        <translation>绘制文件中属于它的部分</translation>
    </message>
    <message>
        <source>%1=%2: %1 is the name of a file.</source>
        <translation>%1=%2：%1 是文件名。</translation>
    </message>
    <message>
        <source>%1 of %2 findings are wrong, the first one: %3</source>
        <translation>%2 项结果中有 %1 项错误，第一项：%3</translation>
    </message>
    <message>
        <source>all %1 findings are right; the control fails as it must: %2</source>
        <translation>全部 %1 项结果正确；对照如预期失败：%2</translation>
    </message>
    <message>
        <source>The system gives no thread for this: close other programs.</source>
        <translation>系统无法为此提供线程：请关闭其他程序。</translation>
    </message>
    <message>
        <source>of the headroom, % [95 %]</source>
        <translation>占余地的比例，% [95 %]</translation>
    </message>
    <message>
        <source>Left out, but drawn after all: less than one in %1 triangles of the object is left out, those that face away counted half, and drawing all of it in the order of neighbours is faster.</source>
        <translation>已剔除但仍绘制：该物体的三角形中剔除的不到 %1 分之一（背向的按一半计），按相邻顺序全部绘制更快。</translation>
    </message>
    <message>
        <source>No scene is open.</source>
        <translation>没有打开的场景。</translation>
    </message>
    <message>
        <source>The figure cannot be drawn: %1</source>
        <translation>无法绘制此图：%1</translation>
    </message>
    <message>
        <source>the way taken until then</source>
        <translation>到此为止所走的路径</translation>
    </message>
    <message>
        <source>Figure %1: no corner ray meets the object in this view. Choose another case or pose.</source>
        <translation>图 %1：在此视点没有角光线与物体相交。请选择其他情形或视点。</translation>
    </message>
    <message>
        <source>eye</source>
        <translation>视点</translation>
    </message>
    <message>
        <source>visible region, on the surface</source>
        <translation>可见区域，在表面上</translation>
    </message>
    <message>
        <source>its box, on the surface</source>
        <translation>其包围盒，在表面上</translation>
    </message>
    <message>
        <source>S of the bands of %1 in one sector</source>
        <translation>一个扇区中宽 %1 的环带的 S</translation>
    </message>
    <message>
        <source>hidden for good by a nearer band, though its S is larger</source>
        <translation>虽然 S 更大，但因较近的环带而一直被剔除</translation>
    </message>
    <message>
        <source>rim of what is drawn: there the shell ends</source>
        <translation>所绘部分的边缘：壳到此为止</translation>
    </message>
    <message>
        <source>It lost nothing in %1 views (&lt; 3/%1).</source>
        <translation>在 %1 个视图中没有丢失任何东西（&lt; 3/%1）。</translation>
    </message>
    <message>
        <source>It loses %1 of a million pixels, in %2 of %3 views.</source>
        <translation>每百万像素丢失 %1 个，出现在 %3 个视图中的 %2 个。</translation>
    </message>
    <message>
        <source>It builds no structure.</source>
        <translation>它不构建任何结构。</translation>
    </message>
    <message>
        <source>Its structure takes %1 bytes and %2 ms to build, which no frame pays back.</source>
        <translation>其结构占 %1 字节，构建需 %2 ms，任何帧都无法收回。</translation>
    </message>
    <message>
        <source>Its structure takes %1 bytes and %2 ms to build, paid back after %3 frames.</source>
        <translation>其结构占 %1 字节，构建需 %2 ms，%3 帧之后收回。</translation>
    </message>
    <message>
        <source>No culling could gain here for certain: drawing exactly what is visible is ×%1.</source>
        <translation>这里任何剔除都不一定有收益：只绘制可见部分也只是 ×%1。</translation>
    </message>
    <message>
        <source>That is more than drawing exactly what is visible gains by OpenGL, which is ×%1.</source>
        <translation>这超过了用 OpenGL 只绘制可见部分的收益 ×%1。</translation>
    </message>
    <message>
        <source>Any culling could gain ×%1 at most; this is %2 % of the time that could be saved.</source>
        <translation>任何剔除最多可达 ×%1；这里节省了可节省时间的 %2 %。</translation>
    </message>
    <message>
        <source>Drawing everything is best here: nothing that may be used is faster.</source>
        <translation>这里绘制全部最好：可用的策略没有更快的。</translation>
    </message>
    <message>
        <source>Drawing everything is best here, by %1: ×%2 the speed of drawing both sides.</source>
        <translation>这里绘制全部最好（%1）：速度是绘制双面的 ×%2。</translation>
    </message>
    <message>
        <source>%1 is best here: ×%2 the speed of drawing everything.</source>
        <translation>这里 %1 最好：速度是绘制全部的 ×%2。</translation>
    </message>
    <message>
        <source>the limit of culling</source>
        <translation>剔除的极限</translation>
    </message>
    <message>
        <source>in the race to the end</source>
        <translation>参与比较直到最后</translation>
    </message>
    <message>
        <source>slower: its interval excludes the best</source>
        <translation>较慢：其区间不含最佳</translation>
    </message>
    <message>
        <source>far slower at the first views</source>
        <translation>在最初的视图中慢得多</translation>
    </message>
    <message>
        <source>promises nothing in these views</source>
        <translation>在这些视图中不作任何保证</translation>
    </message>
    <message>
        <source>loses more than is allowed</source>
        <translation>丢失超过允许值</translation>
    </message>
    <message>
        <source>Nothing was measured that could be advised.</source>
        <translation>没有测得可供建议的结果。</translation>
    </message>
    <message>
        <source>trying strategies</source>
        <translation>正在尝试各策略</translation>
    </message>
    <message>
        <source>building its structure takes longer than %1 s</source>
        <translation>构建其结构超过 %1 秒</translation>
    </message>
    <message>
        <source>racing</source>
        <translation>正在比赛</translation>
    </message>
    <message>
        <source>%1 names no measurement: say its number as in 3, or number and strategy as in 3:frustum.</source>
        <translation>%1 不是测量：请用编号（如 3）或编号加策略（如 3:frustum）指定。</translation>
    </message>
    <message>
        <source>Measurements %1 and %2 cannot be compared: their %3 differ.</source>
        <translation>无法比较测量 %1 和 %2：二者的%3不同。</translation>
    </message>
    <message>
        <source>scenes</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>camera paths</source>
        <translation>相机路径</translation>
    </message>
    <message>
        <source>picture sizes</source>
        <translation>图像尺寸</translation>
    </message>
    <message>
        <source>Measurement %1 has no run of %2. It has: %3.</source>
        <translation>测量 %1 中没有 %2。其中有：%3。</translation>
    </message>
    <message>
        <source>Measurements %1 and %2 cannot be compared: they have no run or pose in common.</source>
        <translation>无法比较测量 %1 和 %2：没有共同的策略或视点。</translation>
    </message>
    <message>
        <source>B has %1 times the speed of A; of single frames there is no interval</source>
        <translation>B 的速度是 A 的 %1 倍；只有单帧，没有置信区间</translation>
    </message>
    <message>
        <source>B is faster: %1 times the speed of A</source>
        <translation>B 更快：速度是 A 的 %1 倍</translation>
    </message>
    <message>
        <source>B is slower: %1 times the speed of A</source>
        <translation>B 更慢：速度是 A 的 %1 倍</translation>
    </message>
    <message>
        <source>no difference that this measurement tells: B has %1 times the speed of A</source>
        <translation>此次测量看不出差别：B 的速度是 A 的 %1 倍</translation>
    </message>
    <message>
        <source>%1 is no result store, or is damaged. Name another file.</source>
        <translation>%1 不是结果库，或已损坏。请指定其他文件。</translation>
    </message>
    <message>
        <source>%1 is in use: another program has been writing to it for half a minute.</source>
        <translation>%1 正在使用中：另一个程序已写入半分钟。</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. What was stored before is there.</source>
        <translation>无法写入 %1：%2。此前存入的内容仍在。</translation>
    </message>
    <message>
        <source>The result store %1 cannot be opened: %2.</source>
        <translation>无法打开结果库 %1：%2。</translation>
    </message>
    <message>
        <source>%1 was written by a newer version of Cullscope (layout %2, this one knows %3): use that one.</source>
        <translation>%1 由更新版本的 Cullscope 写入（布局 %2，本版本只支持到 %3）：请使用那个版本。</translation>
    </message>
    <message>
        <source>%1 has no measurement %2: list them with cullbench store %1 list.</source>
        <translation>%1 中没有测量 %2：用 cullbench store %1 list 列出。</translation>
    </message>
    <message>
        <source>Speed against a baseline that draws the same sides</source>
        <translation>相对于绘制相同面的基准的速度</translation>
    </message>
    <message>
        <source>Speed against drawing everything</source>
        <translation>相对于绘制全部的速度</translation>
    </message>
    <message>
        <source>Speed against drawing all front faces</source>
        <translation>相对于绘制全部正面的速度</translation>
    </message>
    <message>
        <source>fps in the slowest view</source>
        <translation>最慢视图的 fps</translation>
    </message>
    <message>
        <source>Share of the headroom, %</source>
        <translation>占余地的比例，%</translation>
    </message>
    <message>
        <source>Culled triangles, %</source>
        <translation>剔除的三角形，%</translation>
    </message>
    <message>
        <source>Culling, % of the frame</source>
        <translation>剔除耗时，占帧 %</translation>
    </message>
    <message>
        <source>Build time, ms</source>
        <translation>构建时间，ms</translation>
    </message>
    <message>
        <source>Structure, bytes</source>
        <translation>结构，字节</translation>
    </message>
    <message>
        <source>Missed per million</source>
        <translation>每百万丢失</translation>
    </message>
    <message>
        <source>Largest hole, pixels</source>
        <translation>最大空洞，像素</translation>
    </message>
    <message>
        <source>shape: exact set</source>
        <translation>形状：精确</translation>
    </message>
    <message>
        <source>shape: lossless</source>
        <translation>形状：无损</translation>
    </message>
    <message>
        <source>shape: lossy</source>
        <translation>形状：有损</translation>
    </message>
    <message>
        <source>There is no figure &quot;%1&quot;; there are %2.</source>
        <translation>没有指标“%1”；可用的有 %2。</translation>
    </message>
    <message>
        <source>0 (&lt; 3/%1)</source>
        <translation>0 (&lt; 3/%1)</translation>
    </message>
    <message>
        <source>front: nothing lost</source>
        <translation>前沿：无丢失</translation>
    </message>
    <message>
        <source>front: something lost</source>
        <translation>前沿：有丢失</translation>
    </message>
    <message>
        <source>trying views</source>
        <translation>正在尝试各视图</translation>
    </message>
    <message>
        <source>azimuth of the eye, degrees</source>
        <translation>视点方位角，度</translation>
    </message>
    <message>
        <source>elevation of the eye, degrees</source>
        <translation>视点仰角，度</translation>
    </message>
    <message>
        <source>the worst view</source>
        <translation>最差视图</translation>
    </message>
    <message>
        <source>plan of the places: x</source>
        <translation>位置平面图：x</translation>
    </message>
    <message>
        <source>No view was tried.</source>
        <translation>没有尝试任何视图。</translation>
    </message>
    <message>
        <source>%1 gains least where it has ×%2 the speed of drawing the same sides; %3 views were tried.</source>
        <translation>%1 收益最小处的速度是绘制相同面的 ×%2；共尝试 %3 个视图。</translation>
    </message>
    <message>
        <source>%1 lost nothing in %2 views (&lt; 3/%2).</source>
        <translation>%1 在 %2 个视图中没有丢失任何东西（&lt; 3/%2）。</translation>
    </message>
    <message>
        <source>%1 loses most where it loses %2 of %3 covered pixels; it loses something in %4 of %5 views.</source>
        <translation>%1 丢失最多处在 %3 个覆盖像素中丢失 %2 个；%5 个视图中有 %4 个有丢失。</translation>
    </message>
    <message>
        <source>Missed of a million covered pixels: %1</source>
        <translation>每百万覆盖像素的丢失：%1</translation>
    </message>
    <message>
        <source>Speed against drawing the same sides: %1</source>
        <translation>相对于绘制相同面的速度：%1</translation>
    </message>
    <message>
        <source>false negatives, triangles, %</source>
        <translation>假阴性，三角形，%</translation>
    </message>
    <message>
        <source>false positives, triangles, %</source>
        <translation>假阳性，三角形，%</translation>
    </message>
    <message>
        <source>false negatives, objects, %</source>
        <translation>假阴性，物体，%</translation>
    </message>
    <message>
        <source>false positives, objects, %</source>
        <translation>假阳性，物体，%</translation>
    </message>
    <message>
        <source>missed of the covered pixels, ppm</source>
        <translation>覆盖像素中的丢失，ppm</translation>
    </message>
    <message>
        <source>pixel errors, ppm</source>
        <translation>像素错误，ppm</translation>
    </message>
    <message>
        <source>popping, events per 1,000 frames</source>
        <translation>突变，每 1,000 帧事件数</translation>
    </message>
    <message>
        <source>popping, pixels</source>
        <translation>突变，像素</translation>
    </message>
    <message>
        <source>popping, duration in frames</source>
        <translation>突变，持续帧数</translation>
    </message>
    <message>
        <source>popping, pixels that change, ppm</source>
        <translation>突变，变化的像素，ppm</translation>
    </message>
    <message>
        <source>image difference, mean, ppm</source>
        <translation>图像差异，平均，ppm</translation>
    </message>
    <message>
        <source>silhouette error, pixels</source>
        <translation>轮廓误差，像素</translation>
    </message>
    <message>
        <source>image difference, p99, %</source>
        <translation>图像差异，p99，%</translation>
    </message>
    <message>
        <source>pixel errors of the worst view, ppm</source>
        <translation>最差视图的像素错误，ppm</translation>
    </message>
    <message>
        <source>%1 is no history of experiments: it is passed over.</source>
        <translation>%1 不是实验记录，已跳过。</translation>
    </message>
    <message>
        <source>pose</source>
        <translation>视点</translation>
    </message>
    <message>
        <source>objects hidden one by one</source>
        <translation>逐个被遮挡的物体</translation>
    </message>
    <message>
        <source>objects that occlude</source>
        <translation>起遮挡作用的物体</translation>
    </message>
    <message>
        <source>walk and occluders</source>
        <translation>遍历与遮挡体</translation>
    </message>
    <message>
        <source>It lies in a group of %1 objects, whose box no occluder hides.</source>
        <translation>它位于含 %1 个物体的组中，没有遮挡体遮住该组的盒。</translation>
    </message>
    <message>
        <source>Occluders</source>
        <translation>遮挡体</translation>
    </message>
    <message>
        <source>&amp;Occluders</source>
        <translation>遮挡体(&amp;O)</translation>
    </message>
    <message>
        <source>Show in the active view which triangles hide what lies behind them</source>
        <translation>在活动视图中显示哪些三角形遮住其后的内容</translation>
    </message>
    <message>
        <source>drawn as an occluder</source>
        <translation>作为遮挡体绘制</translation>
    </message>
    <message>
        <source>ask the buffer: is its box hidden?</source>
        <translation>询问缓冲：它的盒被遮挡吗？</translation>
    </message>
    <message>
        <source>yes: hidden, leave all its objects out</source>
        <translation>是：被遮挡，剔除其全部物体</translation>
    </message>
    <message>
        <source>no: visit(parts), nearest first</source>
        <translation>否：visit(各部分)，近者优先</translation>
    </message>
    <message>
        <source>an object: test and ask likewise</source>
        <translation>物体：同样测试并询问</translation>
    </message>
    <message>
        <source>not hidden: put it into the buffer</source>
        <translation>未被遮挡：放入缓冲</translation>
    </message>
    <message>
        <source>ask again about each object kept</source>
        <translation>对保留的每个物体再问一次</translation>
    </message>
    <message>
        <source>How many pixels the triangles of an occluder have on average, seen face on: smaller ones hide little.</source>
        <translation>遮挡体的三角形正对视点时平均有多少像素：更小的几乎遮不住什么。</translation>
    </message>
    <message>
        <source>How many triangles all occluders of a frame may have together.</source>
        <translation>一帧的所有遮挡体合计最多可有多少三角形。</translation>
    </message>
    <message>
        <source>What occluders hid</source>
        <translation>遮挡体遮住的内容</translation>
    </message>
    <message>
        <source>Occlusion by a depth buffer in software</source>
        <translation>软件深度缓冲遮挡剔除</translation>
    </message>
    <message>
        <source>Draws the largest triangles of near objects into a depth buffer on the processor, and leaves out what lies behind them.</source>
        <translation>在处理器上把近处物体最大的三角形画入深度缓冲，并剔除其后的内容。</translation>
    </message>
    <message>
        <source>Masked occlusion in software</source>
        <translation>软件掩码遮挡剔除</translation>
    </message>
    <message>
        <source>As occlusion by a depth buffer, with two depths and a mask for 32 pixels: much faster, and hides nearly as much.</source>
        <translation>与深度缓冲遮挡相同，但每 32 个像素只用两个深度和一个掩码：快得多，遮挡的几乎一样多。</translation>
    </message>
    <message>
        <source>Its %1 largest triangles go into the buffer: facing the eye at its nearest point they have at least %2 pixels on average.</source>
        <translation>其最大的 %1 个三角形进入缓冲：在最近点正对视点时，平均至少有 %2 个像素。</translation>
    </message>
    <message>
        <source>Nothing is in the buffer yet that could hide its box: it counts as visible.</source>
        <translation>缓冲中还没有能遮住它的盒的内容：视为可见。</translation>
    </message>
    <message>
        <source>Its triangles lie in %1 smaller boxes, and occluders hide each of them.</source>
        <translation>它的三角形位于 %1 个更小的盒中，遮挡体遮住了每一个。</translation>
    </message>
    <message>
        <source>Its triangles lie in %1 smaller boxes, and occluders do not hide all of them.</source>
        <translation>它的三角形位于 %1 个更小的盒中，遮挡体没有全部遮住。</translation>
    </message>
    <message>
        <source>Its box, grown by %1, reaches before the near plane or lies beside the picture: it counts as visible.</source>
        <translation>扩大 %1 后的盒伸到近平面之前，或位于画面之外：视为可见。</translation>
    </message>
    <message>
        <source>Its box, grown by %1, begins %2 ahead and covers at most %3 pixels: one of them shows no occluder, so it counts as visible.</source>
        <translation>扩大 %1 后的盒始于前方 %2 处，最多覆盖 %3 个像素：其中有像素没有遮挡体，故视为可见。</translation>
    </message>
    <message>
        <source>Its box, grown by %1, begins %2 ahead and covers at most %3 pixels: all show occluders, the farthest %4 ahead, which hide it.</source>
        <translation>扩大 %1 后的盒始于前方 %2 处，最多覆盖 %3 个像素：所有像素都有遮挡体，最远的在前方 %4 处，将它遮住。</translation>
    </message>
    <message>
        <source>Its box, grown by %1, begins %2 ahead and covers at most %3 pixels: all show occluders, but the farthest is %4 ahead, so it counts as visible.</source>
        <translation>扩大 %1 后的盒始于前方 %2 处，最多覆盖 %3 个像素：所有像素都有遮挡体，但最远的在前方 %4 处，故视为可见。</translation>
    </message>
    <message>
        <source>clusters of triangles</source>
        <translation>三角形簇</translation>
    </message>
    <message>
        <source>bounds of the clusters</source>
        <translation>簇的包围体</translation>
    </message>
    <message>
        <source>whole clusters of triangles of which anything is visible</source>
        <translation>有任何部分可见的整个三角形簇</translation>
    </message>
    <message>
        <source>clusters</source>
        <translation>簇</translation>
    </message>
    <message>
        <source>occluders</source>
        <translation>遮挡体</translation>
    </message>
    <message>
        <source>The object &quot;%1&quot; is tested as one box, then by its clusters; it has %2 triangles.</source>
        <translation>物体“%1”先作为一个盒、再按其簇检测；它有 %2 个三角形。</translation>
    </message>
    <message>
        <source>Boxes of clusters</source>
        <translation>簇的盒</translation>
    </message>
    <message>
        <source>Boxes of cl&amp;usters</source>
        <translation>簇的盒(&amp;U)</translation>
    </message>
    <message>
        <source>Show in the active view the boxes of the clusters, or of groups of them that were decided together, by what became of them</source>
        <translation>在活动视图中按结果显示簇的盒，或一起判定的簇组的盒</translation>
    </message>
    <message>
        <source>hidden by nearer ones: leave it out</source>
        <translation>被更近的遮挡：剔除</translation>
    </message>
    <message>
        <source>else it occludes those behind it</source>
        <translation>否则它遮挡后面的</translation>
    </message>
    <message>
        <source>box hidden: leave it out</source>
        <translation>盒被遮挡：剔除</translation>
    </message>
    <message>
        <source>Clusters of triangles</source>
        <translation>三角形簇</translation>
    </message>
    <message>
        <source>Cuts meshes into clusters of neighbouring triangles and tests these, from large groups to single ones, against the frustum, by the cones of their normals and by what lies before them: loses nothing on any mesh.</source>
        <translation>将网格切成相邻三角形的簇，从大组到单个簇，依次以视锥体、法线锥和位于其前方的物体检测：任何网格都不丢失任何内容。</translation>
    </message>
    <message>
        <source>it is not</source>
        <translation>不检测</translation>
    </message>
    <message>
        <source>a depth for every pixel</source>
        <translation>每个像素一个深度</translation>
    </message>
    <message>
        <source>two depths and a mask for each 8 × 4 pixels</source>
        <translation>每 8 × 4 像素两个深度和一个掩码</translation>
    </message>
    <message>
        <source>Whether clusters whose triangles all face away are left out (where only front sides are drawn).</source>
        <translation>是否剔除三角形全部背向的簇（仅在只绘制正面时）。</translation>
    </message>
    <message>
        <source>How many triangles a cluster has at most. An object of no more is one cluster.</source>
        <translation>一个簇最多有多少三角形。不超过此数的物体为一个簇。</translation>
    </message>
    <message>
        <source>back sides of what is drawn</source>
        <translation>所绘部分的背面</translation>
    </message>
    <message>
        <source>perpendicular axis</source>
        <translation>垂直轴</translation>
    </message>
    <message>
        <source>to the eye</source>
        <translation>朝向视点</translation>
    </message>
    <message>
        <source>R of the largest S, from the origin O</source>
        <translation>最大 S 的 R，自原点 O 起</translation>
    </message>
    <message>
        <source>front: from the eye</source>
        <translation>正面：从视点看</translation>
    </message>
    <message>
        <source>back: from the opposite side, into the hollow shell</source>
        <translation>背面：从对面看进空壳</translation>
    </message>
    <message>
        <source>its back sides, seen from within: the darker, the deeper in the hollow</source>
        <translation>其背面，从内部看：凹处越深越暗</translation>
    </message>
    <message>
        <source>the same point P in both</source>
        <translation>两图中的同一点 P</translation>
    </message>
    <message>
        <source>Ray %1: its R beside that of the triangles of each cell</source>
        <translation>光线 %1：其 R 与各单元三角形的 R 对照</translation>
    </message>
    <message>
        <source>R of the triangles of a cell</source>
        <translation>单元中三角形的 R</translation>
    </message>
    <message>
        <source>R of the ray</source>
        <translation>光线的 R</translation>
    </message>
    <message>
        <source>hit</source>
        <translation>命中</translation>
    </message>
    <message>
        <source>corner ray; pale is what lies behind a surface</source>
        <translation>角光线；在面后的部分为浅色</translation>
    </message>
    <message>
        <source>Once for each mesh</source>
        <translation>每个网格一次</translation>
    </message>
    <message>
        <source>For each object, in every frame</source>
        <translation>每帧，对每个物体</translation>
    </message>
    <message>
        <source>%1, byte %2: the text of the level&apos;s entities cannot be read here. Fetch or compile the level again.</source>
        <translation>%1，字节 %2：此处无法读取关卡的实体文本。请重新获取或编译该关卡。</translation>
    </message>
    <message>
        <source>%1, byte %2: an array of the level ends within a record. Fetch or compile the level again.</source>
        <translation>%1，字节 %2：关卡的一个数组在记录中间结束。请重新获取或编译该关卡。</translation>
    </message>
    <message>
        <source>%1 does not begin with IBSP, as levels of Quake 3 do. Levels of other games are not read: convert them to a mesh.</source>
        <translation>%1 不像 Quake 3 关卡那样以 IBSP 开头。不读取其他游戏的关卡：请将其转换为网格。</translation>
    </message>
    <message>
        <source>%1 is a level of version %2; only version %3, that of Quake 3, is read. Convert it to a mesh.</source>
        <translation>%1 是版本 %2 的关卡；只读取 Quake 3 的版本 %3。请将其转换为网格。</translation>
    </message>
    <message>
        <source>%1, byte %2: an array of the level is to end at byte %3, after the end of the file. The file was cut off or changed: fetch it again.</source>
        <translation>%1，字节 %2：关卡的一个数组应在字节 %3 处结束，超出了文件末尾。文件被截断或更改：请重新获取。</translation>
    </message>
    <message>
        <source>%1, byte %2: there is no surface of kind %3. Fetch or compile the level again.</source>
        <translation>%1，字节 %2：不存在种类为 %3 的表面。请重新获取或编译该关卡。</translation>
    </message>
    <message>
        <source>%1, byte %2: a patch has %3 control points; the sides are odd numbers from 3 on, and their product is the number of vertices. Fetch or compile the level again.</source>
        <translation>%1，字节 %2：曲面片有 %3 个控制点；每边应为不小于 3 的奇数，其乘积应等于顶点数。请重新获取或编译该关卡。</translation>
    </message>
    <message>
        <source>%1, byte %2: the node %3 of the BSP tree has two parents. Fetch or compile the level again.</source>
        <translation>%1，字节 %2：BSP 树的节点 %3 有两个父节点。请重新获取或编译该关卡。</translation>
    </message>
    <message>
        <source>%1, byte %2: the file has no room for which of %3 clusters see which. Fetch or compile the level again.</source>
        <translation>%1，字节 %2：文件没有足够空间存放 %3 个簇之间的可见性。请重新获取或编译该关卡。</translation>
    </message>
    <message>
        <source>Surfaces left out that the game does not draw, or draws as sky: %1.</source>
        <translation>省略的表面（游戏不绘制，或绘制为天空）：%1。</translation>
    </message>
    <message>
        <source>Billboards left out, which have no place of their own: %1.</source>
        <translation>省略的公告板（没有固定的位置）：%1。</translation>
    </message>
    <message>
        <source>Surfaces left out of models that no entity places: %1.</source>
        <translation>省略的表面（其模型没有实体放置）：%1。</translation>
    </message>
    <message>
        <source>%1, byte %2: the record here names %3 items from number %4 on, but the file has %5 of them. Fetch or compile the level again.</source>
        <translation>%1，字节 %2：此处的记录引用从编号 %4 起的 %3 项，但文件中只有 %5 项。请重新获取或编译该关卡。</translation>
    </message>
    <message>
        <source>%1 names the accessor %2, which it does not have. Export the file again.</source>
        <translation>%1 引用了不存在的访问器 %2。请重新导出文件。</translation>
    </message>
    <message>
        <source>%1: the accessor %2 takes its numbers from where the file has no buffer. The file was cut off or changed: fetch or export it again.</source>
        <translation>%1：访问器 %2 从没有缓冲区的位置读取数值。文件被截断或更改：请重新获取或导出。</translation>
    </message>
    <message>
        <source>%1: the accessor %2 has more elements than its buffer view has room for. The file was cut off or changed: fetch or export it again.</source>
        <translation>%1：访问器 %2 的元素多于其缓冲区视图所能容纳的数量。文件被截断或更改：请重新获取或导出。</translation>
    </message>
    <message>
        <source>%1: the accessor %2 does not have %3 numbers an element of a kind that can stand there. Export the file again.</source>
        <translation>%1：访问器 %2 的每个元素不是 %3 个此处允许的数值。请重新导出文件。</translation>
    </message>
    <message>
        <source>%1: the accessor %2 replaces elements in a way that is not possible. Export the file again.</source>
        <translation>%1：访问器 %2 以不可能的方式替换元素。请重新导出文件。</translation>
    </message>
    <message>
        <source>%1: the accessor %2 replaces an element that it does not have. Export the file again.</source>
        <translation>%1：访问器 %2 替换了不存在的元素。请重新导出文件。</translation>
    </message>
    <message>
        <source>%1: the accessor %2 has to have whole numbers without a sign. Export the file again.</source>
        <translation>%1：访问器 %2 必须是无符号整数。请重新导出文件。</translation>
    </message>
    <message>
        <source>%1, byte %2: objects and arrays lie deeper in each other than %3. Export the file again.</source>
        <translation>%1，字节 %2：对象和数组的嵌套深度超过 %3。请重新导出文件。</translation>
    </message>
    <message>
        <source>%1, byte %2: this is glTF of version %3; only version 2 is read. Export the scene as glTF 2.0.</source>
        <translation>%1，字节 %2：这是版本 %3 的 glTF；只读取版本 2。请将场景导出为 glTF 2.0。</translation>
    </message>
    <message>
        <source>%1, byte %2: a chunk is to have %3 bytes, more than the file. The file was cut off or changed: fetch it again.</source>
        <translation>%1，字节 %2：数据块应有 %3 字节，超过文件本身。文件被截断或更改：请重新获取。</translation>
    </message>
    <message>
        <source>%1, byte %2: the file is to have %3 bytes and has fewer. The file was cut off: fetch it again.</source>
        <translation>%1，字节 %2：文件应有 %3 字节，实际更少。文件被截断：请重新获取。</translation>
    </message>
    <message>
        <source>%1, byte %2: a chunk of JSON must stand here. Export the file again.</source>
        <translation>%1，字节 %2：此处必须是 JSON 数据块。请重新导出文件。</translation>
    </message>
    <message>
        <source>%1, byte %2: the chunk has %3 bytes, which is no multiple of 4. Export the file again.</source>
        <translation>%1，字节 %2：数据块有 %3 字节，不是 4 的倍数。请重新导出文件。</translation>
    </message>
    <message>
        <source>%1: a mesh that is compressed with Draco does not have its attribute %2. Export the file again.</source>
        <translation>%1：用 Draco 压缩的网格没有属性 %2。请重新导出文件。</translation>
    </message>
    <message>
        <source>%1: a mesh that is compressed with Draco cannot be decoded: %2. Fetch or export the file again.</source>
        <translation>%1：无法解码用 Draco 压缩的网格：%2。请重新获取或导出文件。</translation>
    </message>
    <message>
        <source>%1: a mesh is compressed with a version of Draco that is not read. Export the file again.</source>
        <translation>%1：网格用不支持读取的 Draco 版本压缩。请重新导出文件。</translation>
    </message>
    <message>
        <source>%1 places no surface that can be shown in its scene. Export the scene with its meshes.</source>
        <translation>%1 的场景中没有放置可显示的表面。请连同网格一起导出场景。</translation>
    </message>
    <message>
        <source>Points and lines left out, which have no surface: %1 primitives.</source>
        <translation>省略的点和线（没有表面）：%1 个图元。</translation>
    </message>
    <message>
        <source>Primitives left out that have no positions: %1.</source>
        <translation>省略的没有位置的图元：%1。</translation>
    </message>
    <message>
        <source>Objects left out that lie beyond 1e30: %1.</source>
        <translation>省略的超出 1e30 的物体：%1。</translation>
    </message>
    <message>
        <source>Skins are not applied; objects that stand as they were modelled: %1.</source>
        <translation>不应用蒙皮；保持建模姿态的物体：%1。</translation>
    </message>
    <message>
        <source>Morph targets are not applied; primitives that have some: %1.</source>
        <translation>不应用变形目标；带有变形目标的图元：%1。</translation>
    </message>
    <message>
        <source>Animations are not played: %1.</source>
        <translation>不播放的动画：%1。</translation>
    </message>
    <message>
        <source>Scenes of the file that are not shown, because one at a time is: %1.</source>
        <translation>文件中未显示的场景（一次只显示一个）：%1。</translation>
    </message>
    <message>
        <source>%1 takes a buffer from &quot;%2&quot;, which is not in its own folder or below. Put the buffers beside it, or export it as one file (.glb).</source>
        <translation>%1 从不在其所在文件夹或子文件夹中的“%2”读取缓冲区。请将缓冲区放在文件旁边，或导出为单个文件（.glb）。</translation>
    </message>
    <message>
        <source>%1 takes a buffer from &quot;%2&quot;, which does not exist. Put the buffers beside it, or export it as one file (.glb).</source>
        <translation>%1 从不存在的“%2”读取缓冲区。请将缓冲区放在文件旁边，或导出为单个文件（.glb）。</translation>
    </message>
    <message>
        <source>%1 has more than 4 GB. Split the file, or put its buffers into files beside it.</source>
        <translation>%1 超过 4 GB。请拆分文件，或将缓冲区放入旁边的文件。</translation>
    </message>
    <message>
        <source>%1 cannot be read as glTF 2.0: %2. Export the file again.</source>
        <translation>%1 无法作为 glTF 2.0 读取：%2。请重新导出文件。</translation>
    </message>
    <message>
        <source>%1 requires the extension &quot;%2&quot;, which is not read. Export the file without it.</source>
        <translation>%1 需要扩展“%2”，该扩展不支持读取。请在不使用它的情况下导出文件。</translation>
    </message>
    <message>
        <source>%1 names the scene %2, which it does not have. Export the file again.</source>
        <translation>%1 引用了不存在的场景 %2。请重新导出文件。</translation>
    </message>
    <message>
        <source>%1 names the node %2, which it does not have. Export the file again.</source>
        <translation>%1 引用了不存在的节点 %2。请重新导出文件。</translation>
    </message>
    <message>
        <source>%1: the node %2 has two parents or is its own ancestor. Export the file again.</source>
        <translation>%1：节点 %2 有两个父节点，或是自身的祖先。请重新导出文件。</translation>
    </message>
    <message>
        <source>%1: the transform of the node %2 does not have the numbers that it needs. Export the file again.</source>
        <translation>%1：节点 %2 的变换缺少所需的数值。请重新导出文件。</translation>
    </message>
    <message>
        <source>%1: the matrix of the node %2 is not affine. Export the file again.</source>
        <translation>%1：节点 %2 的矩阵不是仿射变换。请重新导出文件。</translation>
    </message>
    <message>
        <source>%1 names the mesh %2, which it does not have. Export the file again.</source>
        <translation>%1 引用了不存在的网格 %2。请重新导出文件。</translation>
    </message>
    <message>
        <source>%1: the instances of the node %2 have transforms of different numbers. Export the file again.</source>
        <translation>%1：节点 %2 的实例变换数量不一致。请重新导出文件。</translation>
    </message>
    <message>
        <source>OpenGL is asked about boxes: %1; its answers come later</source>
        <translation>向 OpenGL 询问包围盒：%1 个；答案稍后到来</translation>
    </message>
    <message>
        <source>OpenGL is asked about boxes: %1, in groups: %2; its answers come later</source>
        <translation>向 OpenGL 询问包围盒：%1 个，分为 %2 组；答案稍后到来</translation>
    </message>
    <message>
        <source>OpenGL is asked about boxes: %1, in groups: %2; groups hit: %3</source>
        <translation>向 OpenGL 询问包围盒：%1 个，分为 %2 组；命中的组：%3 个</translation>
    </message>
    <message>
        <source>OpenGL cannot be asked about a group of no boxes.</source>
        <translation>不能就没有盒子的组询问 OpenGL。</translation>
    </message>
    <message>
        <source>OpenGL is asked about %1 boxes, and their groups have %2 boxes: each box belongs to one group.</source>
        <translation>向 OpenGL 询问 %1 个盒子，而它们的组共有 %2 个盒子：每个盒子须属于一个组。</translation>
    </message>
    <message>
        <source>It was visible in the frame before: it counts as visible without asking.</source>
        <translation>上一帧中可见：不询问即视为可见。</translation>
    </message>
    <message>
        <source>There is no answer about it of the frame before: it counts as visible.</source>
        <translation>没有上一帧关于它的答案：视为可见。</translation>
    </message>
    <message>
        <source>At the end of the frame OpenGL is asked about it, for the next frame: boxes: %1.</source>
        <translation>在帧末为下一帧就它询问 OpenGL：盒子 %1 个。</translation>
    </message>
    <message>
        <source>By the answers of the frame before it is hidden; it is asked about for the next frame, boxes: %1.</source>
        <translation>按上一帧的答案它被遮挡；为下一帧再次询问，盒子：%1 个。</translation>
    </message>
    <message>
        <source>OpenGL was asked about it, boxes: %1; it shows before what is drawn.</source>
        <translation>已就它询问 OpenGL，盒子：%1 个；它在已绘制内容之前可见。</translation>
    </message>
    <message>
        <source>OpenGL was asked about it, boxes: %1; what is drawn hides all of it.</source>
        <translation>已就它询问 OpenGL，盒子：%1 个；已绘制内容将其完全遮住。</translation>
    </message>
    <message>
        <source>OpenGL was asked about it, boxes: %1, and others at once, together %2; of these something shows, so each is asked about by itself.</source>
        <translation>已就它（盒子：%1 个）与其他组一次询问 OpenGL，共 %2 个组；其中有可见的内容，因此逐个再问。</translation>
    </message>
    <message>
        <source>OpenGL was asked about it, boxes: %1, and others at once, together %2; what is drawn hides all of them.</source>
        <translation>已就它（盒子：%1 个）与其他组一次询问 OpenGL，共 %2 个组；已绘制内容将它们全部遮住。</translation>
    </message>
    <message>
        <source>Its box, grown by %1, reaches before the near plane: it counts as visible without asking.</source>
        <translation>其扩大 %1 后的盒子伸到近平面之前：不询问即视为可见。</translation>
    </message>
    <message>
        <source>visit the nearest group left</source>
        <translation>访问剩余组中最近的一个</translation>
    </message>
    <message>
        <source>first, near or visible before: visible</source>
        <translation>第一个、近处或先前可见：可见</translation>
    </message>
    <message>
        <source>a leaf and due: ask again at the end</source>
        <translation>是叶且到期：帧末再问</translation>
    </message>
    <message>
        <source>else ask OpenGL, several in one query</source>
        <translation>否则问 OpenGL，一次查询多个</translation>
    </message>
    <message>
        <source>some of several show: ask one by one</source>
        <translation>多个中有可见的：逐个再问</translation>
    </message>
    <message>
        <source>visible: visit(parts), nearest first</source>
        <translation>可见：访问(各部分)，由近及远</translation>
    </message>
    <message>
        <source>Coherent hierarchical culling (CHC++)</source>
        <translation>连贯层次剔除（CHC++）</translation>
    </message>
    <message>
        <source>Draws what was visible in the frame before, and asks OpenGL about what was hidden, many groups at once.</source>
        <translation>绘制上一帧可见的内容，并就先前被遮挡的内容一次以多个组询问 OpenGL。</translation>
    </message>
    <message>
        <source>How many frames later answers about hidden groups are used; 0: they are waited for, and nothing is lost.</source>
        <translation>关于被遮挡组的答案在多少帧之后使用；0：等待答案，不会丢失任何内容。</translation>
    </message>
    <message>
        <source>How many groups that were hidden are gathered before OpenGL is asked about them.</source>
        <translation>收集多少个先前被遮挡的组之后再询问 OpenGL。</translation>
    </message>
    <message>
        <source>How many groups one query covers at most; 1: each has a query of its own.</source>
        <translation>一次查询最多涵盖多少个组；1：每个组单独查询。</translation>
    </message>
    <message>
        <source>After how many frames a visible group without parts is asked about again.</source>
        <translation>没有部分的可见组在多少帧之后再次询问。</translation>
    </message>
    <message>
        <source>After how many frames that is done for the first time.</source>
        <translation>首次在多少帧之后再次询问。</translation>
    </message>
    <message>
        <source>a random part of these frames, so that the queries spread</source>
        <translation>这些帧数中随机的一部分，使查询分散</translation>
    </message>
    <message>
        <source>all of these frames</source>
        <translation>全部这些帧数</translation>
    </message>
    <message>
        <source>How many levels below a group lie the boxes by which it is asked about, at most; 0: by its own box.</source>
        <translation>询问一个组所用的盒子最多位于其下多少层；0：用它自己的盒子。</translation>
    </message>
    <message>
        <source>How many times the surface of the group&apos;s own box these boxes have together, at most.</source>
        <translation>这些盒子的表面积之和最多是该组自身盒子的多少倍。</translation>
    </message>
    <message>
        <source>nothing drawn beyond</source>
        <translation>此后不再绘制</translation>
    </message>
    <message>
        <source>α is the angle from the sight ray, seen from the middle of the sphere: the paper&apos;s near half, up to 180° across, has α up to 90°.</source>
        <translation>α 是从球心看去与视线的夹角：论文所说 180° 以内的近侧一半，其 α 不超过 90°。</translation>
    </message>
    <message>
        <source>from the side, as in Figures 5 to 7, with what is left out</source>
        <translation>从侧面看（同图 5 至 7），连同未绘制的部分</translation>
    </message>
    <message>
        <source>the way of the view in this figure</source>
        <translation>本图视图所走的路径</translation>
    </message>
    <message>
        <source>The scene has no view cells: it has less than two objects, or too many triangles. Each object may be visible.</source>
        <translation>场景没有视点单元：物体少于两个，或三角形太多。每个物体都可能可见。</translation>
    </message>
    <message>
        <source>The sets are made for surfaces that hide from both sides, and this frame draws fronts alone: each object may be visible.</source>
        <translation>这些集合是为两面都遮挡的表面建立的，而本帧只绘制正面：每个物体都可能可见。</translation>
    </message>
    <message>
        <source>The eye lies in no view cell: each object may be visible.</source>
        <translation>视点不在任何视点单元中：每个物体都可能可见。</translation>
    </message>
    <message>
        <source>The near plane or the pixels of this view are beyond what the proofs allow for: each object may be visible.</source>
        <translation>此视图的近平面或像素超出证明所容许的范围：每个物体都可能可见。</translation>
    </message>
    <message>
        <source>The eye lies in view cell %1, from which %2 objects may be seen.</source>
        <translation>视点位于视点单元 %1，从那里可能看见 %2 个物体。</translation>
    </message>
    <message>
        <source>objects not in the cell&apos;s set</source>
        <translation>不在单元集合中的物体</translation>
    </message>
    <message>
        <source>objects outside the frustum</source>
        <translation>视锥体外的物体</translation>
    </message>
    <message>
        <source>The culling eye lies in no view cell.</source>
        <translation>剔除视点不在任何视点单元中。</translation>
    </message>
    <message>
        <source>sets=%1: the scene came without potentially visible sets, which levels of Quake 3 (.bsp) have. Take %2 or %3.</source>
        <translation>sets=%1：场景不带潜在可见集，Quake 3 的关卡（.bsp）才有。请用 %2 或 %3。</translation>
    </message>
    <message>
        <source>the cell&apos;s set</source>
        <translation>单元的集合</translation>
    </message>
    <message>
        <source>The object &quot;%1&quot; has %2 triangles, which the cell&apos;s set has together or not at all.</source>
        <translation>物体&quot;%1&quot;有 %2 个三角形，单元的集合要么全有，要么全无。</translation>
    </message>
    <message>
        <source>View cell</source>
        <translation>视点单元</translation>
    </message>
    <message>
        <source>View &amp;cell</source>
        <translation>视点单元(&amp;C)</translation>
    </message>
    <message>
        <source>Show in the active view the cell from anywhere in which the drawn objects may be seen</source>
        <translation>在活动视图中显示所绘物体从其任意处都可能被看见的单元</translation>
    </message>
    <message>
        <source>view cell of the culling eye</source>
        <translation>剔除视点的视点单元</translation>
    </message>
    <message>
        <source>find the view cell of the eye</source>
        <translation>查找视点所在的视点单元</translation>
    </message>
    <message>
        <source>none: each object is in the set</source>
        <translation>没有：每个物体都在集合中</translation>
    </message>
    <message>
        <source>not in the cell&apos;s set: leave it out</source>
        <translation>不在单元集合中：剔除</translation>
    </message>
    <message>
        <source>test it against the frustum</source>
        <translation>用视锥体测试它</translation>
    </message>
    <message>
        <source>Potentially visible sets</source>
        <translation>潜在可见集</translation>
    </message>
    <message>
        <source>Draws what may be seen from anywhere in the eye&apos;s cell, worked out beforehand for all cells.</source>
        <translation>绘制从视点所在单元任意处可能看见的内容，对所有单元预先算出。</translation>
    </message>
    <message>
        <source>Where the cells&apos; sets come from.</source>
        <translation>单元的集合从何而来。</translation>
    </message>
    <message>
        <source>what rays from the cell meet</source>
        <translation>从单元发出的光线所遇到的</translation>
    </message>
    <message>
        <source>all but what is proven to be hidden from the cell</source>
        <translation>除已证明从单元看不见者外的全部</translation>
    </message>
    <message>
        <source>the sets that came with the scene&apos;s file</source>
        <translation>随场景文件而来的集合</translation>
    </message>
    <message>
        <source>How many cells lie along the longest side of the scene.</source>
        <translation>沿场景最长边有多少个单元。</translation>
    </message>
    <message>
        <source>How many more times a cell is halved that a surface crosses.</source>
        <translation>有表面穿过的单元再对半划分多少次。</translation>
    </message>
    <message>
        <source>How many rays look around from a cell.</source>
        <translation>从一个单元向四周发出多少条光线。</translation>
    </message>
    <message>
        <source>Whether a cell&apos;s sampled set also has what the cells beside it see.</source>
        <translation>单元的采样集合是否也包含相邻单元所见的内容。</translation>
    </message>
    <message>
        <source>What the rays&apos; random numbers begin with.</source>
        <translation>光线随机数的起始值。</translation>
    </message>
    <message>
        <source>What the cell&apos;s set has</source>
        <translation>单元集合的内容</translation>
    </message>
    <message>
        <source>Rays from view cells</source>
        <translation>从视点单元发出光线</translation>
    </message>
    <message>
        <source>Proofs of what is hidden</source>
        <translation>证明哪些被遮挡</translation>
    </message>
    <message>
        <source>A strategy draws %1 ranges by the answers to a question that has %2: each range needs one.</source>
        <translation>策略要按一个有 %2 个答案的问题绘制 %1 个范围：每个范围需要一个答案。</translation>
    </message>
    <message>
        <source>objects drawn first</source>
        <translation>先绘制的物体</translation>
    </message>
    <message>
        <source>objects tested</source>
        <translation>测试过的物体</translation>
    </message>
    <message>
        <source>objects hidden</source>
        <translation>被遮挡的物体</translation>
    </message>
    <message>
        <source>objects drawn after a test</source>
        <translation>测试后绘制的物体</translation>
    </message>
    <message>
        <source>objects for the next frame</source>
        <translation>留给下一帧先绘制的物体</translation>
    </message>
    <message>
        <source>walk and pyramid</source>
        <translation>遍历与金字塔</translation>
    </message>
    <message>
        <source>It lies in a group of %1 objects, of which some are in the frustum.</source>
        <translation>它位于含 %1 个物体的组中，其中一些在视锥体之内。</translation>
    </message>
    <message>
        <source>visible before, or near: draw it</source>
        <translation>先前可见或很近：绘制</translation>
    </message>
    <message>
        <source>the others by rounds, nearest first</source>
        <translation>其余分轮处理，由近到远</translation>
    </message>
    <message>
        <source>reduce the depth drawn to a pyramid</source>
        <translation>把已绘深度归约成金字塔</translation>
    </message>
    <message>
        <source>test boxes against its texels</source>
        <translation>将盒与其纹素比较</translation>
    </message>
    <message>
        <source>behind all: hidden, leave it out</source>
        <translation>在全部之后：被遮挡，剔除</translation>
    </message>
    <message>
        <source>else draw it, in the same frame</source>
        <translation>否则在同一帧中绘制</translation>
    </message>
    <message>
        <source>reduce again, test all: hidden now</source>
        <translation>再归约并全部测试：现已被遮挡</translation>
    </message>
    <message>
        <source>else visible for the next frame</source>
        <translation>否则对下一帧算作可见</translation>
    </message>
    <message>
        <source>Hierarchical depth in two passes</source>
        <translation>两遍层次深度</translation>
    </message>
    <message>
        <source>Draws what was visible in the frame before, and has the GPU test all else against a pyramid of its depth and draw it in the same frame.</source>
        <translation>绘制上一帧可见的内容，再由 GPU 将其余内容与其深度金字塔比较，并在同一帧中绘制。</translation>
    </message>
    <message>
        <source>In how many rounds the other objects are tested and drawn, the nearest first: what one draws hides what the next one tests.</source>
        <translation>其余物体分几轮测试和绘制，由近到远：一轮所绘遮住下一轮所测。</translation>
    </message>
    <message>
        <source>Objects by the depth pyramid</source>
        <translation>按深度金字塔划分的物体</translation>
    </message>
    <message>
        <source>It was visible at the end of the frame before: it is drawn first, without a test.</source>
        <translation>上一帧结束时可见：不经测试，先行绘制。</translation>
    </message>
    <message>
        <source>The depth of what is drawn so far is reduced to a pyramid: levels %1; a texel has the farthest depth of the pixels below it.</source>
        <translation>把目前所绘内容的深度归约成金字塔：%1 层；一个纹素存其下各像素中最远的深度。</translation>
    </message>
    <message>
        <source>Its triangles lie in %1 smaller boxes, and each lies behind all texels of the pyramid that it may cover.</source>
        <translation>它的三角形位于 %1 个更小的盒中，每个盒都在其可能覆盖的所有金字塔纹素之后。</translation>
    </message>
    <message>
        <source>Its triangles lie in %1 smaller boxes, and not all lie behind the texels of the pyramid that they may cover: it counts as visible.</source>
        <translation>它的三角形位于 %1 个更小的盒中，这些盒并非都在其可能覆盖的金字塔纹素之后：视为可见。</translation>
    </message>
    <message>
        <source>Its box, grown by %1, begins %2 ahead. Of the texels that it may cover on level %3 of the pyramid, %4, one has pixels that show nothing yet: it counts as visible.</source>
        <translation>扩大 %1 后的盒始于前方 %2 处。在金字塔第 %3 层可能覆盖的 %4 个纹素中，有一个含有尚无内容的像素：视为可见。</translation>
    </message>
    <message>
        <source>Its box, grown by %1, begins %2 ahead. It lies behind all texels that it may cover on level %3 of the pyramid: %4; the farthest is %5 ahead.</source>
        <translation>扩大 %1 后的盒始于前方 %2 处。它在金字塔第 %3 层可能覆盖的全部 %4 个纹素之后；最远的在前方 %5 处。</translation>
    </message>
    <message>
        <source>Its box, grown by %1, begins %2 ahead. Of the texels that it may cover on level %3 of the pyramid, %4, the farthest is %5 ahead: it counts as visible.</source>
        <translation>扩大 %1 后的盒始于前方 %2 处。在金字塔第 %3 层可能覆盖的 %4 个纹素中，最远的在前方 %5 处：视为可见。</translation>
    </message>
    <message>
        <source>At the end of the frame it is not hidden: the next frame draws it first.</source>
        <translation>本帧结束时未被遮挡：下一帧先绘制它。</translation>
    </message>
    <message>
        <source>At the end of the frame it is hidden: the next frame does not draw it first.</source>
        <translation>本帧结束时被遮挡：下一帧不先绘制它。</translation>
    </message>
    <message>
        <source>boxes of clusters</source>
        <translation>簇的盒</translation>
    </message>
    <message>
        <source>How it is found that clusters are hidden: by large triangles of near objects, drawn on the processor, or by what the frame has drawn.</source>
        <translation>如何得知簇被遮挡：按在处理器上绘制的近处对象的大三角形，或按本帧已绘内容。</translation>
    </message>
    <message>
        <source>a pyramid of the depth that the frame has drawn, on the GPU</source>
        <translation>本帧所绘深度的金字塔，在 GPU 上</translation>
    </message>
    <message>
        <source>%1, line %2: &quot;%3&quot; is not a usable number. Write one from -1e30 to 1e30, with a point for decimals.</source>
        <translation>%1 第 %2 行：“%3”不是可用的数。请写 -1e30 到 1e30 之间的数，小数用点表示。</translation>
    </message>
    <message>
        <source>%1, line %2: the polygon has no area. Give it corners around a face, not all on one line.</source>
        <translation>%1 第 %2 行：多边形没有面积。请让各角围成一个面，不要都在一条直线上。</translation>
    </message>
    <message>
        <source>%1, line %2: the plane&apos;s normal is 0. At least one of its three numbers must not be 0.</source>
        <translation>%1 第 %2 行：平面的法线为 0。三个数中至少有一个不能为 0。</translation>
    </message>
    <message>
        <source>any hit: region between them</source>
        <translation>有命中：其间的区域</translation>
    </message>
    <message>
        <source>back side of a surface</source>
        <translation>表面的背面</translation>
    </message>
    <message>
        <source>plane that the eye is before</source>
        <translation>视点位于其前方的平面</translation>
    </message>
    <message>
        <source>plane that the eye is behind</source>
        <translation>视点位于其后方的平面</translation>
    </message>
    <message>
        <source>S of a contour band</source>
        <translation>等高环带的 S</translation>
    </message>
    <message>
        <source>box of the region</source>
        <translation>区域的方框</translation>
    </message>
    <message>
        <source>corner ray</source>
        <translation>角光线</translation>
    </message>
    <message>
        <source>height of the sight line with a band&apos;s slope</source>
        <translation>具有环带斜率的视线高度</translation>
    </message>
    <message>
        <source>Kept as camera %1. Alt+%1 goes back to it.</source>
        <translation>已保存为相机 %1。按 Alt+%1 返回。</translation>
    </message>
    <message>
        <source>objects</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>triangles drawn a view</source>
        <translation>每个视图绘制的三角形</translation>
    </message>
    <message>
        <source>copies</source>
        <translation>副本</translation>
    </message>
    <message>
        <source>triangles of the scene</source>
        <translation>场景的三角形</translation>
    </message>
    <message>
        <source>Frame time by the size of the scene</source>
        <translation>帧时间随场景规模的变化</translation>
    </message>
    <message>
        <source>Triangles drawn by the size of the scene</source>
        <translation>绘制的三角形随场景规模的变化</translation>
    </message>
    <message>
        <source>Frame time in one of ever more courts</source>
        <translation>庭院越来越多时其中一个的帧时间</translation>
    </message>
    <message>
        <source>Each court is a copy of the scene behind walls of its own. All views are of one court, the same for all sizes: what is visible stays the same, while the frustum has more and more in it.</source>
        <translation>每个庭院是场景的一份副本，四周有自己的围墙。所有视图都在同一个庭院里，与规模无关：可见的东西不变，而视锥体中的东西越来越多。</translation>
    </message>
    <message>
        <source>An exponent of 1 means that the time grows as the scene does, 0 that it does not grow.</source>
        <translation>指数为 1 表示时间与场景同步增长，0 表示不增长。</translation>
    </message>
    <message>
        <source>Frame time in a field of ever more objects</source>
        <translation>物体越来越多的场地的帧时间</translation>
    </message>
    <message>
        <source>This OpenGL is %1, which draws on the processor. Leave out --gpu for sizes that suit it, or run this where a graphics card draws.</source>
        <translation>此 OpenGL 是 %1，由处理器绘制。去掉 --gpu 以使用适合它的规模，或在由显卡绘制的机器上运行。</translation>
    </message>
    <message>
        <source>n by n copies of a scene, each behind walls of its own: who stands in one sees no other</source>
        <translation>场景的 n × n 份副本，各有自己的围墙：站在其中一个里看不到其他的</translation>
    </message>
    <message>
        <source>courts along each side</source>
        <translation>每边的庭院数</translation>
    </message>
    <message>
        <source>height of the walls, as a share of the scene&apos;s; 0: there are none</source>
        <translation>围墙高度与场景高度之比；0：没有围墙</translation>
    </message>
    <message>
        <source>foot of P in the plane of x and y</source>
        <translation>P 在 xy 平面上的垂足</translation>
    </message>
    <message>
        <source>Seen by one camera in Figures 5 to 7: beside the sight ray, which comes from the right, and a little from behind.</source>
        <translation>图 5 至 7 用同一相机观察：从视线旁边稍偏后，视线来自右侧。</translation>
    </message>
    <message>
        <source>level of the largest S: beyond α = 90°, bands farther from the eye that stay below it are hidden</source>
        <translation>最大 S 的高度：α = 90° 之外，离视点更远且低于它的带被遮挡</translation>
    </message>
    <message>
        <source>θ, zenith angle from the z axis</source>
        <translation>θ，从 z 轴量起的天顶角</translation>
    </message>
    <message>
        <source>φ, azimuth from the x axis to the foot of P</source>
        <translation>φ，从 x 轴到 P 的垂足的方位角</translation>
    </message>
    <message>
        <source>walk(cell); if open, its parts</source>
        <translation>遍历(单元)，未定则遍历各部分</translation>
    </message>
    <message>
        <source>few pixels: triangle by triangle</source>
        <translation>像素少时：逐个三角形</translation>
    </message>
    <message>
        <source>Whether triangles that hold no pixel centre or face away are left out of the drawn cells one by one (where the picture has few pixels for each).</source>
        <translation>是否从绘制的单元中逐个剔除不含像素中心或背向的三角形（当图像中每个三角形的像素很少时）。</translation>
    </message>
    <message>
        <source>triangles one by one</source>
        <translation>逐个三角形</translation>
    </message>
    <message>
        <source>Of these %1 triangles %2 face away and %3 hold no pixel centre: they are left out one by one.</source>
        <translation>这 %1 个三角形中有 %2 个背向、%3 个不含像素中心：将它们逐个剔除。</translation>
    </message>
    <message>
        <source>The triangle faces away, however rounding and snapping move its corners: OpenGL would drop it.</source>
        <translation>无论舍入和对齐怎样移动顶点，该三角形都背向：OpenGL 也会丢弃它。</translation>
    </message>
    <message>
        <source>No pixel centre lies in the triangle, however rounding and snapping move its corners.</source>
        <translation>无论舍入和对齐怎样移动顶点，该三角形内都没有像素中心。</translation>
    </message>
    <message>
        <source>facing away, one by one</source>
        <translation>背向，逐个</translation>
    </message>
    <message>
        <source>without a pixel centre</source>
        <translation>不含像素中心</translation>
    </message>
    <message>
        <source>Normal cones are not used: both sides of the triangles are drawn, the test is switched off, or all of the object is in view and too few of its cells could face away.</source>
        <translation>未使用法线锥：绘制三角形的两面，该测试已关闭，或物体全部可见且可能背向的单元太少。</translation>
    </message>
    <message>
        <source>The kernel&apos;s horizon is not used here: the near plane cuts the bounding sphere, the object is too small in the picture, all of it is in view and it has few triangles, or the test is switched off.</source>
        <translation>此处未使用内核的地平线：近平面切过包围球，物体在图像中太小，物体全部可见且三角形较少，或该测试已关闭。</translation>
    </message>
    <message>
        <source>Horizon not used: at the near plane, too far away, or of few triangles</source>
        <translation>未使用地平线：碰到近平面、距离太远或三角形太少</translation>
    </message>
    <message>
        <source>Of the drawn cells, left out one by one: %1</source>
        <translation>已绘制单元中逐个略去：%1</translation>
    </message>
    <message>
        <source>where a band begins that is drawn, by sector</source>
        <translation>被绘制的环带由此开始，按扇区</translation>
    </message>
    <message>
        <source>where a band begins that is hidden, by sector</source>
        <translation>被遮挡的环带由此开始，按扇区</translation>
    </message>
    <message>
        <source>the largest S: from the sight ray through O to a triangle&apos;s centroid</source>
        <translation>最大的 S：从过 O 的视线到三角形的质心</translation>
    </message>
    <message>
        <source>S of a band that is drawn, at its own triangle</source>
        <translation>被绘制的环带的 S，位于其三角形处</translation>
    </message>
    <message>
        <source>Drawn in vain: drawn, but in no pixel of the picture from the eye. White cells: no triangle has its centroid there.</source>
        <translation>徒劳绘制：已绘制，但在视点图像中没有占据任何像素。白色单元：没有三角形的质心落在其中。</translation>
    </message>
    <message>
        <source>Four corner rays, from where they enter the sphere</source>
        <translation>四条角光线，从进入包围球处开始</translation>
    </message>
    <message>
        <source>Each row but the first differs from spherical by one reading. Views are the three cases of Table 2, 36 views from 1.6 to 2.7 radii with 45 degrees, 12 random ones with 45 degrees in which one to three corner rays hit, and 12 views of the whole object.</source>
        <translation>除第一行外，每行与 spherical 只差一种解读。视图为表 2 的三种情况、距离 1.6 至 2.7 倍半径且 45 度的 36 个视图、45 度且有一到三条角光线命中的 12 个随机视图，以及看到整个物体的 12 个视图。</translation>
    </message>
    <message>
        <source>none found</source>
        <translation>未找到</translation>
    </message>
    <message>
        <source>such random views, of 20,000</source>
        <translation>这样的随机视图，共 20,000 个</translation>
    </message>
    <message>
        <source>On the object the second, fourth, … band from the eye is darker; what is wrongly culled has an outline.</source>
        <translation>物体上从视点起的第二、第四……条环带较暗；被错误剔除的部分带有轮廓线。</translation>
    </message>
    <message>
        <source>The index map has as many entries as triangles touch cells at 360 × 180. The paper stores R with each entry; here R is kept by cell, as its nearest and its farthest value, unless storage=entries of spherical is chosen, which table-1 builds and spherical-readings times.</source>
        <translation>索引图的条目数是 360 × 180 时三角形触及单元格的次数。论文为每个条目存储 R；此处按单元格保存其最近和最远的 R，除非选用 spherical 的 storage=entries：table-1 构建它，spherical-readings 为其计时。</translation>
    </message>
    <message>
        <source>the same, enlarged</source>
        <translation>同一部分，放大</translation>
    </message>
    <message>
        <source>Here a cell has its nearest and farthest R. With storage=entries of spherical, R stands with each entry of the index map, and the centroid map has R, θ, φ, as in the paper&apos;s formulas.</source>
        <translation>此处每个单元格保存最近和最远的 R。使用 spherical 的 storage=entries 时，如论文公式所示，索引图的每个条目带有 R，重心图带有 R、θ、φ。</translation>
    </message>
    <message>
        <source>storage=entries: MB</source>
        <translation>storage=entries：MB</translation>
    </message>
    <message>
        <source>its build, ms</source>
        <translation>其构建，毫秒</translation>
    </message>
    <message>
        <source>All of it goes to the pipeline</source>
        <translation>全部送入管线</translation>
    </message>
    <message>
        <source>cells along a ray</source>
        <translation>角光线经过的单元格</translation>
    </message>
    <message>
        <source>What the maps keep of R.</source>
        <translation>图中保存的 R。</translation>
    </message>
    <message>
        <source>of each cell its nearest and farthest surface</source>
        <translation>每个单元格的最近和最远表面</translation>
    </message>
    <message>
        <source>with each entry of the index map its centroid&apos;s (Table 1)</source>
        <translation>索引图每个条目的重心的 R（表 1）</translation>
    </message>
    <message>
        <source>Ray %1 is at R = %2 to %3 in this cell: of %4 triangles with an R near that one is hit.</source>
        <translation>在此单元中光线 %1 处于 R = %2 至 %3：R 与之接近的 %4 个三角形中命中一个。</translation>
    </message>
    <message>
        <source>Ray %1 is at R = %2 to %3 in this cell: of %4 triangles with an R near that none is hit.</source>
        <translation>在此单元中光线 %1 处于 R = %2 至 %3：R 与之接近的 %4 个三角形一个也没有命中。</translation>
    </message>
    <message>
        <source>sight ray through the middle of the sphere, seen through the object</source>
        <translation>穿过球心的视线，透过物体可见</translation>
    </message>
    <message>
        <source>edges of the sector and its bands, numbered from the eye; without triangles a band has no S</source>
        <translation>扇区及其环带的边界，从视点起编号；没有三角形的环带没有 S</translation>
    </message>
    <message>
        <source>its projection on the perpendicular axis, where S is as long</source>
        <translation>其在垂直轴上的投影，轴上的 S 与之等长</translation>
    </message>
    <message>
        <source>wrongly culled: visible, but hidden by S: %1 of the pixels that the object covers</source>
        <translation>误剔除：可见但被 S 遮挡：占物体所覆盖像素的 %1</translation>
    </message>
    <message>
        <source>Above, lines within the object are pale. The map shows the outermost surface in each direction from O, lit as a relief: slopes are darker than the scale.</source>
        <translation>上图中物体内部的线较浅。该图显示从 O 出发各方向上最外层的表面，按浮雕方式受光：斜面比色标更暗。</translation>
    </message>
    <message>
        <source>of the first cell with the triangle that is hit</source>
        <translation>含有被命中三角形的第一个单元的 R</translation>
    </message>
    <message>
        <source>way from the sphere, its end: cells (θ, φ) = (%1, %2) to (%3, %4)</source>
        <translation>从包围球起的路程，其末段：单元 (θ, φ) = (%1, %2) 到 (%3, %4)</translation>
    </message>
    <message>
        <source>Contour bands on the maps, S by sector</source>
        <translation>图上的等高环带，各扇区的 S</translation>
    </message>
    <message>
        <source>Near half, and what no larger S hides: ranges of the memory access map</source>
        <translation>近侧一半以及未被更大的 S 遮挡的部分：内存访问图的区间</translation>
    </message>
    <message>
        <source>The share of the faces that spherical considers where the case occurs, over 48 distances of 1.02 to 12 radii, three targets and twelve directions around the case&apos;s own: the least and the most; the faces of the nearest view that a search between these distances finds; and of 20,000 random views (the eye 1.05 to 4 radii away, any target within the bounding sphere, any roll) those of the case whose faces are within 5 % of the paper&apos;s. Where the nearest view is within 5 %, or a random one, the case has such views: cells go in steps, so a share between least and most may be that of no view.</source>
        <translation>在出现该情况之处 spherical 所考虑的面的占比，遍及 1.02 至 12 倍半径的 48 个距离、三个目标点和该情况方向周围的十二个方向：最小值与最大值；在这些距离之间搜索到的最接近视图的面数；以及 20,000 个随机视图（视点距离为 1.05 至 4 倍半径，目标点在包围球内任意处，任意滚转）中面数与论文相差 5 % 以内者。最接近的视图或某个随机视图在 5 % 以内时，该情况存在这样的视图：单元格是逐级增减的，因此介于最小与最大之间的占比也可能不属于任何视图。</translation>
    </message>
    <message>
        <source>faces of the nearest view</source>
        <translation>最接近视图的面数</translation>
    </message>
    <message>
        <source>walk(each object); if open, its parts</source>
        <translation>遍历(每个物体)，未定则遍历各部分</translation>
    </message>
    <message>
        <source>Whether triangles that hold no pixel centre or face away are left out of the drawn clusters one by one (where the picture has few pixels for each; not with occlusion=hiz).</source>
        <translation>是否从绘制的簇中逐个剔除不含像素中心或背向的三角形（当图像中每个三角形的像素很少时；occlusion=hiz 时不做）。</translation>
    </message>
    <message>
        <source>The state files are of different versions: the same blocks are other views.</source>
        <translation>状态文件属于不同版本：相同的分块对应不同的视角。</translation>
    </message>
    <message>
        <source>%1 is named twice: name each strategy once.</source>
        <translation>%1 出现了两次：每个策略只写一次。</translation>
    </message>
    <message>
        <source>Name the strategy to be certified.</source>
        <translation>请写出要认证的策略。</translation>
    </message>
    <message>
        <source>Of the visible triangles, those that were not drawn</source>
        <translation>可见三角形中未绘制的</translation>
    </message>
    <message>
        <source>Of the triangles that are not visible, those that were drawn</source>
        <translation>不可见三角形中被绘制的</translation>
    </message>
    <message>
        <source>Of the visible objects, those of which no triangle was drawn</source>
        <translation>可见物体中一个三角形也未绘制的</translation>
    </message>
    <message>
        <source>Of the objects that are not visible, those of which a triangle was drawn</source>
        <translation>不可见物体中绘制了某个三角形的</translation>
    </message>
    <message>
        <source>Of the pixels in which the truth has a surface, those in which the strategy has a farther one or none</source>
        <translation>真值有表面的像素中，策略显示更远表面或无表面的</translation>
    </message>
    <message>
        <source>Of all pixels, those that show a farther or a nearer surface than the truth, or none</source>
        <translation>所有像素中，显示的表面比真值更远、更近或没有表面的</translation>
    </message>
    <message>
        <source>How often an object begins to lose pixels, in a thousand frames along the path</source>
        <translation>沿路径每 1,000 帧中物体开始丢失像素的次数</translation>
    </message>
    <message>
        <source>The most pixels that an object loses in one frame of such an event, mean over the events</source>
        <translation>此类事件中物体在一帧内丢失的最多像素数，按事件平均</translation>
    </message>
    <message>
        <source>For how many frames an object loses pixels in such an event, mean over the events</source>
        <translation>此类事件中物体丢失像素的帧数，按事件平均</translation>
    </message>
    <message>
        <source>Of all pixels, those that are lost in a frame or in the one before it, and not in both</source>
        <translation>所有像素中，仅在某一帧或其前一帧之一丢失的</translation>
    </message>
    <message>
        <source>Difference from the shaded picture of everything, mean of all pixels and colours, of the full range</source>
        <translation>与绘制全部的着色图像之差，所有像素和颜色的平均，占全范围</translation>
    </message>
    <message>
        <source>Pixels that one of both pictures alone covers, for each pixel of the outline: about the mean distance of both outlines</source>
        <translation>仅被两幅图像之一覆盖的像素数除以轮廓像素数：约为两条轮廓的平均距离</translation>
    </message>
    <message>
        <source>Difference from the shaded picture of everything that 99 % of the pixels do not exceed, of the full range</source>
        <translation>与绘制全部的着色图像之差中 99 % 像素不超过的值，占全范围</translation>
    </message>
    <message>
        <source>Pixel errors of the view that has the largest share of them</source>
        <translation>像素错误比例最大的视角的值</translation>
    </message>
    <message>
        <source>These are no results of a block of cullbench certify: %1</source>
        <translation>这不是 cullbench certify 的分块结果：%1</translation>
    </message>
    <message>
        <source>not tried: at its defaults it cannot win</source>
        <translation>未尝试：默认值下无法胜出</translation>
    </message>
    <message>
        <source>A file cannot be converted in memory: %1. Close other programs.</source>
        <translation>无法在内存中转换文件：%1。请关闭其他程序。</translation>
    </message>
    <message>
        <source>%1 cannot be started: %2. Install or build Cullscope again.</source>
        <translation>无法启动 %1：%2。请重新安装或构建 Cullscope。</translation>
    </message>
    <message>
        <source>numbers of windows</source>
        <translation>窗口数</translation>
    </message>
    <message>
        <source>ways of uploading vertices</source>
        <translation>顶点上传方式</translation>
    </message>
    <message>
        <source>%1: &quot;size&quot; must be two whole numbers from 1 to %2: width and height of the picture.</source>
        <translation>%1：“size”必须是 1 到 %2 的两个整数：图像的宽和高。</translation>
    </message>
    <message>
        <source>a flat box above a plane</source>
        <translation>平面上方的扁盒</translation>
    </message>
    <message>
        <source>a sphere that a plane cuts, ten million from the origin</source>
        <translation>距原点一千万处被平面切开的球</translation>
    </message>
    <message>
        <source>what is left of a file with broken faces: one triangle</source>
        <translation>含损坏面的文件中余下的：一个三角形</translation>
    </message>
    <message>
        <source>a triangle over the seam of a map of directions</source>
        <translation>跨越方向图接缝的三角形</translation>
    </message>
    <message>
        <source>a triangle around the pole of a map of directions</source>
        <translation>环绕方向图极点的三角形</translation>
    </message>
    <message>
        <source>triangles at azimuths of 90 and 225 degrees</source>
        <translation>方位角 90 度和 225 度的三角形</translation>
    </message>
    <message>
        <source>a triangle with a corner whose azimuth rounds to a whole turn</source>
        <translation>有一个顶点的方位角舍入为整圈的三角形</translation>
    </message>
    <message>
        <source>a triangle with a corner a hundred-millionth of a degree from the pole</source>
        <translation>有一个顶点距极点一亿分之一度的三角形</translation>
    </message>
    <message>
        <source>four hundred boxes, each of which has a name in selection mode</source>
        <translation>四百个盒子，在选择模式下各有名称</translation>
    </message>
    <message>
        <source>%1 is no IFC file of the kind that is read: it does not begin with &quot;%2&quot;. Export it as IFC 2x3 (.ifc, not .ifcXML or .ifcZIP).</source>
        <translation>%1 不是可读取的 IFC 文件：它不以“%2”开头。请导出为 IFC 2x3（.ifc，而非 .ifcXML 或 .ifcZIP）。</translation>
    </message>
    <message>
        <source>%1 breaks off: &quot;%2&quot; is missing at its end. Copy or export it again.</source>
        <translation>%1 中断：末尾缺少“%2”。请重新复制或导出。</translation>
    </message>
    <message>
        <source>%1 has the schema %2; only IFC 2x3 is read. Export the building so, or convert it to glTF.</source>
        <translation>%1 的模式为 %2；只读取 IFC 2x3。请将建筑按此导出，或转换为 glTF。</translation>
    </message>
    <message>
        <source>Shapes left out of kinds that are not read: %1 (%2).</source>
        <translation>省略的形状（其种类不读取）：%1（%2）。</translation>
    </message>
    <message>
        <source>Elements whose openings are not all cut, because of their shape: %1 (the first is #%2).</source>
        <translation>因形状而未能切出全部洞口的构件：%1（第一个为 #%2）。</translation>
    </message>
    <message>
        <source>Other warnings of the reader: %1 (the first: %2).</source>
        <translation>读取程序的其他警告：%1（第一个：%2）。</translation>
    </message>
    <message>
        <source>Converting</source>
        <translation>正在转换</translation>
    </message>
    <message>
        <source>%1 cannot be read: it makes the reader of IFC files (Assimp) crash. Export it again, or convert it to glTF.</source>
        <translation>无法读取 %1：它会使 IFC 读取程序（Assimp）崩溃。请重新导出，或转换为 glTF。</translation>
    </message>
    <message>
        <source>%1 cannot be read as IFC: %2. IFC 2x3 is read; export the building so, or convert it to glTF.</source>
        <translation>%1 无法作为 IFC 读取：%2。可读取 IFC 2x3；请将建筑按此导出，或转换为 glTF。</translation>
    </message>
    <message>
        <source>Speed, same sides</source>
        <translation>速度（同样的面）</translation>
    </message>
    <message>
        <source>Speed, everything</source>
        <translation>速度（全部）</translation>
    </message>
    <message>
        <source>Speed, front faces</source>
        <translation>速度（正面）</translation>
    </message>
    <message>
        <source>Lengths in %1 are taken for metres: only units of the SI are converted.</source>
        <translation>以 %1 为单位的长度按米处理：只转换国际单位制单位。</translation>
    </message>
    <message>
        <source>It lost nothing in %1 views.</source>
        <translation>它在 %1 个视图中没有丢失任何内容。</translation>
    </message>
    <message>
        <source>%1 has no report %2: list them with cullbench store %1 list.</source>
        <translation>%1 没有报告 %2：请用 cullbench store %1 list 列出。</translation>
    </message>
    <message>
        <source>%1 lost nothing in %2 views.</source>
        <translation>%1 在 %2 个视图中没有丢失任何内容。</translation>
    </message>
    <message>
        <source>0 of %1</source>
        <translation>%1 中的 0</translation>
    </message>
    <message>
        <source>%1 decides by a file: choose one as its parameter %2. Until then every triangle is drawn.</source>
        <translation>%1 根据文件作决定：请在其参数 %2 中选择文件。在此之前绘制所有三角形。</translation>
    </message>
    <message>
        <source>%1 is no result file of cullbench measure, race or certify, and no result store. Those of sweeps and experiments have no frames: measure them with --store. Of what a store exported, add that store.</source>
        <translation>%1 既不是 cullbench measure、race 或 certify 的结果文件，也不是结果存储。扫描和实验的结果没有帧：请用 --store 测量。对于从存储导出的内容，请添加该存储。</translation>
    </message>
    <message>
        <source>Nothing of the scene is seen in any of these pictures: what is drawn cannot be judged by them. Give cameras that see it, or larger pictures.</source>
        <translation>这些图像中都看不到场景：无法据此评判所绘制的内容。请给出能看到场景的相机或更大的图像。</translation>
    </message>
    <message>
        <source>A closed mesh of two boxes that cross, one of which is inside out</source>
        <translation>由两个相交盒子组成的封闭网格，其中一个内外翻转</translation>
    </message>
    <message>
        <source>back faces are seen from outside: back-face culling loses them, and does not promise otherwise</source>
        <translation>从外面能看到背面：背面剔除会丢失它们，也不保证不丢失</translation>
    </message>
    <message>
        <source>a closed mesh of two boxes that cross, one of which is inside out</source>
        <translation>由两个相交盒子组成的封闭网格，其中一个内外翻转</translation>
    </message>
    <message>
        <source>%1 draws exactly the visible triangles, which are found beforehand: what any culling could gain at most. How much of that a method gains is its share of the headroom.</source>
        <translation>%1 恰好绘制可见的三角形，它们是事先找出的：这是任何剔除最多能得到的。方法得到其中多少，就是它占余地的比例。</translation>
    </message>
    <message>
        <source>How many objects of which nothing is known are tested before groups are, those that look largest: what they hide is left out by groups.</source>
        <translation>在测试组之前，先测试多少个尚无所知、看起来最大的物体：被它们遮挡之物按组剔除。</translation>
    </message>
    <message>
        <source>0 as promised, not judged</source>
        <translation>按承诺为 0，未评判</translation>
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
        <source>It uses Qt under the LGPL version 3, linked dynamically: you may replace Qt by a version of your own.</source>
        <translation>它按 LGPL 第 3 版动态链接 Qt：您可以用自己的版本替换 Qt。</translation>
    </message>
    <message>
        <source>Also: OpenMesh and libepoxy, GLM, meshoptimizer, tinyobjloader, OpenImageIO, Embree, oneTBB, OpenSSL, CLI11, nlohmann-json and fmt, each under its own free licence.</source>
        <translation>此外还使用 OpenMesh、libepoxy、GLM、meshoptimizer、tinyobjloader、OpenImageIO、Embree、oneTBB、OpenSSL、CLI11、nlohmann-json 和 fmt，它们各自采用自由许可证。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::AdviseDialog</name>
    <message>
        <source>&amp;Advise</source>
        <translation>建议(&amp;A)</translation>
    </message>
    <message>
        <source>C&amp;ancel</source>
        <translation>取消(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Show it in the active view</source>
        <translation>在活动视图中显示(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>导出(&amp;E)</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>关闭(&amp;L)</translation>
    </message>
    <message>
        <source>Advice: which strategy suits this scene</source>
        <translation>建议：哪种策略适合此场景</translation>
    </message>
    <message>
        <source>Camera path</source>
        <translation>相机路径</translation>
    </message>
    <message>
        <source>A built-in camera path, or a file</source>
        <translation>内置相机路径或文件</translation>
    </message>
    <message>
        <source>Size of the picture</source>
        <translation>图像大小</translation>
    </message>
    <message>
        <source>nothing may be missed</source>
        <translation>不允许丢失</translation>
    </message>
    <message>
        <source>may miss: </source>
        <translation>允许丢失：</translation>
    </message>
    <message>
        <source> per million</source>
        <translation> / 百万</translation>
    </message>
    <message>
        <source>How many of a million covered pixels may be missed</source>
        <translation>每百万覆盖像素允许丢失的数量</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>策略</translation>
    </message>
    <message>
        <source>Promise</source>
        <translation>保证</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>Build time</source>
        <translation>构建时间</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>结构</translation>
    </message>
    <message>
        <source>How it came out</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Strategies by their speed</source>
        <translation>按速度排列的策略</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Advice as JSON…</source>
        <translation>将建议存为 JSON…</translation>
    </message>
    <message>
        <source>Points as CSV…</source>
        <translation>将数据点存为 CSV…</translation>
    </message>
    <message>
        <source>Plot as SVG…</source>
        <translation>将图存为 SVG…</translation>
    </message>
    <message>
        <source>Plot as PDF…</source>
        <translation>将图存为 PDF…</translation>
    </message>
    <message>
        <source>Strategies are being tried on this scene; those that cannot win leave the race early…</source>
        <translation>正在此场景上尝试各策略；不可能胜出的会提前退出…</translation>
    </message>
    <message>
        <source>Each strategy that can serve this scene is measured over a camera path, and what cannot win is left out early. The answer says which one suits, what it would lose, and what its structure costs.</source>
        <translation>沿相机路径测量能用于此场景的每种策略，不可能胜出的会提前排除。结果说明哪种合适、会丢失什么、其结构代价多大。</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Nothing is measured yet. Choose a camera path above and press Advise.</source>
        <translation>尚未测量。请在上方选择相机路径并按“建议”。</translation>
    </message>
    <message>
        <source>Headroom</source>
        <translation>余地</translation>
    </message>
    <message>
        <source>Share of the time saved that any culling could save</source>
        <translation>在任何剔除所能节省的时间中节省的比例</translation>
    </message>
    <message>
        <source>× everything</source>
        <translation>× 绘制全部</translation>
    </message>
    <message>
        <source>Paid back, frames</source>
        <translation>收回所需帧数</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>视图数</translation>
    </message>
    <message>
        <source>How many views were timed. Of a strategy that left early, speed and frame time are the best one&apos;s, times how both compare at these views.</source>
        <translation>计时的视图数。对于提前退出的策略，其速度和帧时间是最佳策略的值乘以两者在这些视图上的比值。</translation>
    </message>
    <message>
        <source>Missed, ppm</source>
        <translation>遗漏，ppm</translation>
    </message>
    <message>
        <source>Missed of a million covered pixels</source>
        <translation>每百万个覆盖像素中遗漏的数量</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::AnswerDialog</name>
    <message>
        <source>What was expected, and what happened</source>
        <translation>预期与实际</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::BarsPanel</name>
    <message>
        <source>There is no scene: nothing was counted yet.</source>
        <translation>没有场景：尚未计数。</translation>
    </message>
    <message>
        <source>The strategy&apos;s decisions are being read…</source>
        <translation>正在读取策略的判定…</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::BarsPlot</name>
    <message>
        <source>Counts</source>
        <translation>计数</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::BudgetBar</name>
    <message>
        <source>Where the triangles went</source>
        <translation>三角形的去向</translation>
    </message>
    <message>
        <source>%1: %2 triangles, %3 %</source>
        <extracomment>A state of triangles, how many, and their share of all.</extracomment>
        <translation>%1：%2 个三角形，%3 %</translation>
    </message>
    <message>
        <source>Not known yet.</source>
        <translation>尚未知。</translation>
    </message>
    <message>
        <source>The view changed since: being counted anew.</source>
        <translation>视图已变化：正在重新统计。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ColumnMenu</name>
    <message>
        <source>As at the first start</source>
        <translation>恢复为首次启动时</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ComparisonDialog</name>
    <message>
        <source>Compare two experiments</source>
        <translation>比较两次实验</translation>
    </message>
    <message>
        <source>%1 · A: %2, B: %3</source>
        <comment>a scene, and the times of two experiments</comment>
        <translation>%1 · A：%2，B：%3</translation>
    </message>
    <message>
        <source>A and B were measured one after the other: what else the machine did then is not in the intervals.</source>
        <translation>A 和 B 先后分别测量：当时机器上其他工作的影响不包含在区间内。</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>策略</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>视点</translation>
    </message>
    <message>
        <source>A, ms</source>
        <translation>A，毫秒</translation>
    </message>
    <message>
        <source>B, ms</source>
        <translation>B，毫秒</translation>
    </message>
    <message>
        <source>× of B to A</source>
        <translation>B 相对 A 的 ×</translation>
    </message>
    <message>
        <source>Missed by A</source>
        <translation>A 丢失的像素</translation>
    </message>
    <message>
        <source>Missed by B</source>
        <translation>B 丢失的像素</translation>
    </message>
    <message>
        <source>What the interval says</source>
        <translation>区间的结论</translation>
    </message>
    <message>
        <source>of single frames there is no interval</source>
        <translation>只有单帧，没有区间</translation>
    </message>
    <message>
        <source>B is faster</source>
        <translation>B 更快</translation>
    </message>
    <message>
        <source>B is slower</source>
        <translation>B 更慢</translation>
    </message>
    <message>
        <source>no difference that it tells</source>
        <translation>看不出差别</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>视点</translation>
    </message>
    <message>
        <source>Frame, ms</source>
        <translation>帧，毫秒</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::Conclusion</name>
    <message>
        <source>×%1 (95 %: %2 to %3)</source>
        <comment>a ratio of times and its interval</comment>
        <translation>×%1（95 %：%2 至 %3）</translation>
    </message>
    <message>
        <source>Fastest without a lost pixel: %1, %2 against drawing everything with the same sides.</source>
        <translation>不丢失像素的最快策略：%1，与绘制相同各面的全部三角形相比 %2。</translation>
    </message>
    <message>
        <source>No strategy that loses no pixel is surely faster than drawing everything with the same sides; the best one is %1 with %2.</source>
        <translation>不丢失像素的策略中，没有一个确定比绘制相同各面的全部三角形更快；最好的是 %1，%2。</translation>
    </message>
    <message>
        <source>Faster, with losses: %1, %2; it loses %3 of a million pixels, most of them at pose %4.</source>
        <translation>更快但有损失：%1，%2；每百万像素丢失 %3 个，姿态 %4 处最多。</translation>
    </message>
    <message>
        <source>%1 promises to lose nothing and lost %2 of a million pixels: the promise is broken.</source>
        <translation>%1 承诺不丢失任何像素，却每百万像素丢失了 %2 个：承诺被违背。</translation>
    </message>
    <message>
        <source>Losses were not measured of every strategy.</source>
        <translation>并非每个策略都测量了损失。</translation>
    </message>
    <message>
        <source>Only baselines were measured: there is nothing to compare.</source>
        <translation>只测量了比较基准：没有可比较的内容。</translation>
    </message>
    <message>
        <source>A software OpenGL drew: on a graphics card drawing takes less, and culling the same.</source>
        <translation>由软件 OpenGL 绘制：在显卡上绘制耗时更少，剔除耗时不变。</translation>
    </message>
    <message>
        <source>The measurement was stopped early: poses are missing.</source>
        <translation>测量被提前停止：缺少一些姿态。</translation>
    </message>
    <message>
        <source>Drawing everything is best here: not even exactly the visible triangles, known beforehand, are surely faster.</source>
        <translation>此处全部绘制最好：即使事先知道恰好可见的三角形，也不一定更快。</translation>
    </message>
    <message>
        <source>Any culling could gain at most %1 here: so much faster are exactly the visible triangles.</source>
        <translation>此处任何剔除最多可获得 %1：这是只绘制可见三角形时的速度。</translation>
    </message>
    <message>
        <source>%1 saves %2 % of the time that can be saved.</source>
        <comment>a strategy</comment>
        <translation>%1 节省了可节省时间的 %2 %。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::CurvePlot</name>
    <message>
        <source>This frame has nothing to show here.</source>
        <translation>这一帧在此没有可显示的内容。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::DocumentCommands</name>
    <message>
        <source>Meshes (%1)</source>
        <translation>网格（%1）</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>会话</translation>
    </message>
    <message>
        <source>Pictures that Cullscope took</source>
        <translation>Cullscope 截取的图像</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>所有文件</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>保存会话</translation>
    </message>
    <message>
        <source>Go to camera %1</source>
        <translation>转到相机 %1</translation>
    </message>
    <message>
        <source>Keep as camera %1</source>
        <translation>保存为相机 %1</translation>
    </message>
    <message>
        <source>Models, sessions and pictures</source>
        <translation>模型、会话和图像</translation>
    </message>
    <message>
        <source>Name a camera</source>
        <translation>命名相机</translation>
    </message>
    <message>
        <source>Go to camera %1: %2</source>
        <comment>its number, its name</comment>
        <translation>转到相机 %1：%2</translation>
    </message>
    <message>
        <source>Camera %1…</source>
        <translation>相机 %1…</translation>
    </message>
    <message>
        <source>Name of camera %1</source>
        <translation>相机 %1 的名称</translation>
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
    <name>cullscope::ui::ExperimentBar</name>
    <message>
        <source>recorded path</source>
        <translation>录制的路径</translation>
    </message>
    <message>
        <source>Open a path file…</source>
        <translation>打开路径文件…</translation>
    </message>
    <message>
        <source>Open a camera path</source>
        <translation>打开相机路径</translation>
    </message>
    <message>
        <source>Camera paths (*.json)</source>
        <translation>相机路径 (*.json)</translation>
    </message>
    <message>
        <source>as the view: %1 × %2</source>
        <translation>与视图相同：%1 × %2</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Open a scene first</source>
        <translation>请先打开场景</translation>
    </message>
    <message>
        <source>Camera path</source>
        <translation>相机路径</translation>
    </message>
    <message>
        <source>Number of poses</source>
        <translation>姿态数</translation>
    </message>
    <message>
        <source>Size of the picture</source>
        <translation>图像大小</translation>
    </message>
    <message>
        <source>Repetitions of each frame</source>
        <translation>每帧的重复次数</translation>
    </message>
    <message>
        <source>repeat until steady</source>
        <translation>重复至稳定</translation>
    </message>
    <message>
        <source>Progress of the experiment</source>
        <translation>实验进度</translation>
    </message>
    <message>
        <source>poses: </source>
        <translation>姿态：</translation>
    </message>
    <message>
        <source>repetitions: </source>
        <translation>重复：</translation>
    </message>
    <message>
        <source>Measures strategies at several values of a parameter and joins their points in the Pareto plot</source>
        <translation>在一个参数的多个取值下测量策略，并在帕累托图中连接各点</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>参数扫描</translation>
    </message>
    <message>
        <source>All of these</source>
        <comment>sweeps over parameters</comment>
        <translation>以下全部</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::FiguresDialog</name>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>关闭(&amp;L)</translation>
    </message>
    <message>
        <source>Figures of Han &amp; Hong 2008</source>
        <translation>Han &amp; Hong 2008 的插图</translation>
    </message>
    <message>
        <source>Figure %1: %2</source>
        <translation>图 %1：%2</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>图</translation>
    </message>
    <message>
        <source>the paper&apos;s bunny</source>
        <translation>论文中的兔子</translation>
    </message>
    <message>
        <source>the open scene</source>
        <translation>打开的场景</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>case %1</source>
        <translation>情形 %1</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>情形</translation>
    </message>
    <message>
        <source>view </source>
        <translation>视点 </translation>
    </message>
    <message>
        <source>View of the case</source>
        <translation>该情形的视点</translation>
    </message>
    <message>
        <source>The figure</source>
        <translation>插图</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>正在绘制…</translation>
    </message>
    <message>
        <source>Save the figure</source>
        <translation>保存插图</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::FlowChartPanel</name>
    <message>
        <source>This strategy has no flow chart.</source>
        <translation>此策略没有流程图。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::FlowChartPlot</name>
    <message>
        <source>Flow chart</source>
        <translation>流程图</translation>
    </message>
    <message>
        <source>%1: the step in hand</source>
        <translation>%1：当前步骤</translation>
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
    <message>
        <source>objects: about %1; triangles: as the mesh has; memory beside the mesh: about %2 MB</source>
        <translation>物体：约 %1 个；三角形：由网格决定；网格之外的内存：约 %2 MB</translation>
    </message>
    <message>
        <source>triangles: about %1; objects: about %2; memory: about %3 MB</source>
        <translation>三角形：约 %1 个；物体：约 %2 个；内存：约 %3 MB</translation>
    </message>
    <message>
        <source>The scene will have: %1.</source>
        <comment>sizes</comment>
        <translation>场景将有：%1。</translation>
    </message>
    <message>
        <source>Generate it</source>
        <translation>仍然生成</translation>
    </message>
    <message>
        <source>So large a scene takes time and memory. Above five million triangles nothing is measured unasked.</source>
        <translation>如此大的场景需要时间和内存。超过五百万个三角形时，未经要求不进行任何测量。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>◀ Back</source>
        <translation>◀ 后退</translation>
    </message>
    <message>
        <source>First page</source>
        <translation>首页</translation>
    </message>
    <message>
        <source>Search the help</source>
        <translation>搜索帮助</translation>
    </message>
    <message>
        <source>Contents of the help</source>
        <translation>帮助目录</translation>
    </message>
    <message>
        <source>No section has all these words.</source>
        <translation>没有包含所有这些词的章节。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::HistoryModel</name>
    <message>
        <source>%1 · %2 ppm missed</source>
        <comment>a ratio of times, missed pixels of a million</comment>
        <translation>%1 · 丢失 %2 ppm</translation>
    </message>
    <message>
        <source>%1, %2
%3</source>
        <comment>scene, time, path and size</comment>
        <translation>%1，%2
%3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>number of a measurement, scene and time</comment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::HistoryPanel</name>
    <message>
        <source>Filter by scene, strategy or date</source>
        <translation>按场景、策略或日期筛选</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>The chosen experiments, or all that the filter leaves, as JSON or CSV</source>
        <translation>所选实验，或筛选后的全部实验，保存为 JSON 或 CSV</translation>
    </message>
    <message>
        <source>Experiments beside each other</source>
        <translation>并列的实验</translation>
    </message>
    <message>
        <source>How many times as fast the later one is, with intervals</source>
        <translation>后一次实验快多少倍，附区间</translation>
    </message>
    <message>
        <source>Choose two experiments by their headings, the second one with Ctrl</source>
        <translation>通过标题选择两次实验，第二次按住 Ctrl</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
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
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>next view or panel</source>
        <translation>下一个视图或面板</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>鼠标</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>单击</translation>
    </message>
    <message>
        <source>select triangle and object; on an axis&apos; end: look from there</source>
        <translation>选中三角形和物体；点在坐标轴端点上则从该方向观察</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Alt + 1 … 4</source>
        <translation>Alt + 1 … 4</translation>
    </message>
    <message>
        <source>go to a kept camera; with Shift: keep this one</source>
        <translation>转到保存的相机；加 Shift：保存当前相机</translation>
    </message>
    <message>
        <source>Ctrl + K</source>
        <translation>Ctrl + K</translation>
    </message>
    <message>
        <source>add this pose to the path</source>
        <translation>把此姿态加入路径</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>空格</translation>
    </message>
    <message>
        <source>play the path, or pause</source>
        <translation>播放路径或暂停</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>freeze culling and fly on</source>
        <translation>冻结剔除并继续飞行</translation>
    </message>
    <message>
        <source>colours by verdict</source>
        <translation>按判定着色</translation>
    </message>
    <message>
        <source>wipe between truth and strategy</source>
        <translation>真值与策略对比</translation>
    </message>
    <message>
        <source>missed and added pixels</source>
        <translation>丢失与多出的像素</translation>
    </message>
    <message>
        <source>next loss</source>
        <translation>下一处丢失</translation>
    </message>
    <message>
        <source>loupe</source>
        <translation>放大镜</translation>
    </message>
    <message>
        <source>axes</source>
        <translation>坐标轴</translation>
    </message>
    <message>
        <source>Window and files</source>
        <translation>窗口与文件</translation>
    </message>
    <message>
        <source>number of views</source>
        <translation>视图数量</translation>
    </message>
    <message>
        <source>Ctrl + O, Ctrl + S</source>
        <translation>Ctrl + O, Ctrl + S</translation>
    </message>
    <message>
        <source>open; save the session</source>
        <translation>打开；保存会话</translation>
    </message>
    <message>
        <source>Ctrl + Z, Ctrl + Shift + Z</source>
        <translation>Ctrl + Z, Ctrl + Shift + Z</translation>
    </message>
    <message>
        <source>undo, redo</source>
        <translation>撤销、重做</translation>
    </message>
    <message>
        <source>screenshot; with Ctrl: without overlays; with Ctrl + Shift: ask</source>
        <translation>截图；加 Ctrl：不含叠加内容；加 Ctrl + Shift：先询问</translation>
    </message>
    <message>
        <source>F1, H</source>
        <translation>F1、H</translation>
    </message>
    <message>
        <source>help; this page</source>
        <translation>帮助；本页</translation>
    </message>
    <message>
        <source>step through the frame; Page Up and Page Down step</source>
        <translation>逐步查看该帧；Page Up 和 Page Down 移动</translation>
    </message>
    <message>
        <source>question first: name what you expect, then reveal</source>
        <translation>先提问：指出预期，再揭示</translation>
    </message>
    <message>
        <source>Ctrl + left drag</source>
        <translation>Ctrl + 左键拖动</translation>
    </message>
    <message>
        <source>in an open question: name all within the rectangle</source>
        <translation>有未答的问题时：指出矩形内的全部物体</translation>
    </message>
    <message>
        <source>turn about what is under the pointer, or the centre of rotation</source>
        <translation>绕指针下的点或旋转中心转动</translation>
    </message>
    <message>
        <source>[ and ]</source>
        <translation>[ 和 ]</translation>
    </message>
    <message>
        <source>fly slower, faster; the speed follows what is ahead</source>
        <translation>飞得更慢、更快；速度随前方物体的距离变化</translation>
    </message>
    <message>
        <source>Alt + ← and →</source>
        <translation>Alt + ← 和 →</translation>
    </message>
    <message>
        <source>one pose of the path back, on</source>
        <translation>路径的上一个、下一个姿态</translation>
    </message>
    <message>
        <source>watch from outside, in another view</source>
        <translation>在另一视图中从外部观察</translation>
    </message>
    <message>
        <source>Ctrl + 1, 2, 4, 6, 8</source>
        <translation>Ctrl + 1, 2, 4, 6, 8</translation>
    </message>
    <message>
        <source>lecture: R shows figures, P points, B blanks, Esc leaves</source>
        <translation>讲课：R 显示数值，P 指示，B 黑屏，Esc 退出</translation>
    </message>
    <message>
        <source>Page Up, Page Down</source>
        <translation>Page Up, Page Down</translation>
    </message>
    <message>
        <source>in a lesson: step back, step on</source>
        <translation>在课程中：上一步，下一步</translation>
    </message>
    <message>
        <source>parallel view, or perspective</source>
        <translation>平行视图或透视视图</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::LectureWindow</name>
    <message>
        <source>%1 – %2</source>
        <comment>strategy, scene</comment>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>Speed: %1</source>
        <translation>速度：%1</translation>
    </message>
    <message>
        <source>Submitted: %1</source>
        <translation>提交：%1</translation>
    </message>
    <message>
        <source>Missed: %1</source>
        <translation>丢失：%1</translation>
    </message>
    <message>
        <source>◀ Back</source>
        <translation>◀ 上一个</translation>
    </message>
    <message>
        <source>Next ▶</source>
        <translation>下一个 ▶</translation>
    </message>
    <message>
        <source>Lecture – Cullscope</source>
        <translation>讲课 – Cullscope</translation>
    </message>
    <message>
        <source>Software OpenGL</source>
        <translation>软件 OpenGL</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>a step of a lesson, number of steps</comment>
        <translation>第 %1 步，共 %2 步</translation>
    </message>
    <message>
        <source>How fast, and what is lost? (R)</source>
        <translation>有多快，丢失了什么？(R)</translation>
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
        <source>Next: press H to see all keys, or open a model of your own.</source>
        <translation>下一步：按 H 查看所有按键，或打开您自己的模型。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>promise, its meaning</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Next: drag in view %1 and watch in view %2 what is left out.</source>
        <translation>下一步：在视图 %1 中拖动，在视图 %2 中观察哪些被剔除。</translation>
    </message>
    <message>
        <source>Next: click on something in a picture to see why it was drawn or left out.</source>
        <translation>下一步：点击画面中的任意处，查看它为何被绘制或被剔除。</translation>
    </message>
    <message>
        <source>What the colours mean</source>
        <translation>颜色含义</translation>
    </message>
    <message>
        <source>%1: %2 triangles in the active view</source>
        <comment>a state of triangles</comment>
        <translation>%1：活动视图中 %2 个三角形</translation>
    </message>
    <message>
        <source>Next: choose another strategy in the view&apos;s menu and compare the figures over the pictures.</source>
        <translation>下一步：在视图的菜单中选择另一种策略，比较图像上方的数据。</translation>
    </message>
    <message>
        <source>Over each picture: speed, same sides drawn · triangles submitted · pixels missed</source>
        <translation>每幅图像上方：速度（相同面） · 提交的三角形 · 丢失的像素</translation>
    </message>
    <message>
        <source>Next: begin with %1lesson 1%2, or drag in a picture to turn the scene.</source>
        <comment>a link in the text</comment>
        <translation>下一步：从%1第 1 课%2开始，或在图像中拖动以转动场景。</translation>
    </message>
    <message>
        <source>Triangles of view %1:</source>
        <translation>视图 %1 的三角形：</translation>
    </message>
    <message>
        <source>drawn, visible or not</source>
        <translation>已绘制，是否可见未知</translation>
    </message>
    <message>
        <source>These views draw other sides, so their × have other baselines.</source>
        <translation>这些视图绘制的面不同，因此 × 的基准也不同。</translation>
    </message>
    <message>
        <source>A frame takes: %1</source>
        <translation>一帧用时：%1</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::LegendStrip</name>
    <message>
        <source>missed pixels</source>
        <translation>丢失的像素</translation>
    </message>
    <message>
        <source>pixels that differ</source>
        <translation>不同的像素</translation>
    </message>
    <message>
        <source>within snapping</source>
        <translation>对齐误差之内</translation>
    </message>
    <message>
        <source>nearer than the truth</source>
        <translation>比真值更近</translation>
    </message>
    <message>
        <source>in hand</source>
        <translation>正在处理</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::LessonBar</name>
    <message>
        <source>%1 of %2</source>
        <comment>a step of a lesson, number of steps</comment>
        <translation>第 %1 步，共 %2 步</translation>
    </message>
    <message>
        <source>One step back (Page Up)</source>
        <translation>上一步 (Page Up)</translation>
    </message>
    <message>
        <source>One step on (Page Down)</source>
        <translation>下一步 (Page Down)</translation>
    </message>
    <message>
        <source>Leave the lesson: what is shown stays</source>
        <translation>退出课程：所示内容保留</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::LessonCommands</name>
    <message>
        <source>Open a lesson</source>
        <translation>打开课程</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>课程</translation>
    </message>
    <message>
        <source>Add as step</source>
        <translation>添加为一步</translation>
    </message>
    <message>
        <source>What is said at this step, in one sentence:</source>
        <translation>这一步要说的话，一句：</translation>
    </message>
    <message>
        <source>The lesson to which the step is added</source>
        <translation>要添加到的课程</translation>
    </message>
    <message>
        <source>Save a handout of the lesson</source>
        <translation>保存课程讲义</translation>
    </message>
    <message>
        <source>Handouts</source>
        <translation>讲义</translation>
    </message>
    <message>
        <source>The steps are shown one after the other…</source>
        <translation>正在逐步显示……</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ListingModel</name>
    <message>
        <source>the current line</source>
        <translation>当前行</translation>
    </message>
    <message>
        <source>decided about the picked triangle</source>
        <translation>对所选三角形作出过判定</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>How many decisions fell at the line</source>
        <translation>落在该行的判定数</translation>
    </message>
    <message>
        <source>Decisions</source>
        <translation>判定数</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ListingPanel</name>
    <message>
        <source>There is no scene: nothing was decided yet.</source>
        <translation>没有场景：尚未作出任何判定。</translation>
    </message>
    <message>
        <source>The strategy&apos;s decisions are being read…</source>
        <translation>正在读取策略的判定…</translation>
    </message>
    <message>
        <source>%1, triangle %2: no decision about it fell at a line.</source>
        <comment>name of an object</comment>
        <translation>%1，三角形 %2：没有关于它的判定落在这些行。</translation>
    </message>
    <message>
        <source>%1, triangle %2: what became of it was decided at line %3.</source>
        <comment>name of an object</comment>
        <translation>%1，三角形 %2：其结果在第 %3 行判定。</translation>
    </message>
    <message>
        <source>Lines of the strategy</source>
        <translation>策略的各行</translation>
    </message>
    <message>
        <source>Decisions up to this step that fell at these lines: %1. The last one fell at line %2.</source>
        <translation>到这一步为止在这些行作出的决定：%1 个。最后一个在第 %2 行。</translation>
    </message>
    <message>
        <source>No decision has fallen yet. Step on with Page Down.</source>
        <translation>尚未作出判定。按 Page Down 前进一步。</translation>
    </message>
    <message>
        <source>Decisions of this frame that fell at these lines: %1.</source>
        <translation>此帧中在这些行作出的判定：%1。</translation>
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
    <name>cullscope::ui::LossModel</name>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Pixels lost</source>
        <translation>丢失像素</translation>
    </message>
    <message>
        <source>Share</source>
        <comment>of all lost pixels</comment>
        <translation>占比</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::LossPanel</name>
    <message>
        <source>Nothing of the scene is in this view: there is nothing to lose.</source>
        <translation>此视图中没有场景内容：无可丢失。</translation>
    </message>
    <message>
        <source>0 of %1 covered pixels lost in this view. One view cannot show a loss rarer than about 3 in %1 (&lt; %2 %).</source>
        <translation>此视图 %1 个覆盖像素中丢失 0 个。仅凭一个视图无法发现低于约 %1 分之 3(&lt; %2 %)的丢失。</translation>
    </message>
    <message>
        <source>There is no scene.</source>
        <translation>没有场景。</translation>
    </message>
    <message>
        <source>The view changed: what it lost is being counted…</source>
        <translation>视图已变化：正在统计丢失像素…</translation>
    </message>
    <message>
        <source>The scene is large: what the view lost is counted when you ask for it.</source>
        <translation>场景很大：仅在您要求时统计丢失像素。</translation>
    </message>
    <message>
        <source>Objects that lost pixels</source>
        <translation>丢失像素的物体</translation>
    </message>
    <message>
        <source>Count now</source>
        <translation>立即统计</translation>
    </message>
    <message>
        <source>%1 of %2 covered pixels lost in this view (%3 %). Holes: %4, pixels of the largest: %5. N shows the next one.</source>
        <comment>numbers of pixels</comment>
        <translation>此视图中覆盖的 %2 个像素丢失了 %1 个（%3 %）。空洞：%4，最大空洞的像素：%5。按 N 查看下一个空洞。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::MainWindow</name>
    <message>
        <source>%1 – Cullscope</source>
        <translation>%1 – Cullscope</translation>
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
        <source>Strategy</source>
        <translation>策略</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>内部</translation>
    </message>
    <message>
        <source>Inside: what the strategy decided, and why</source>
        <translation>内部：策略的决定及其原因</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::MapPanel</name>
    <message>
        <source>Strategies that look up what is visible by direction show their map here.</source>
        <translation>按方向查找可见内容的策略会在此显示其索引图。</translation>
    </message>
    <message>
        <source>&amp;Colours of the map:</source>
        <translation>图的颜色(&amp;C)：</translation>
    </message>
    <message>
        <source>This strategy has no %1.</source>
        <translation>该策略没有%1。</translation>
    </message>
    <message>
        <source>Up to this step there is no %1.</source>
        <translation>到这一步为止没有%1。</translation>
    </message>
    <message>
        <source>This frame has no %1.</source>
        <translation>此帧没有%1。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::MapWidget</name>
    <message>
        <source>The arrow keys go through the cells, with Shift ten at a time; Enter picks a triangle of the cell.</source>
        <translation>方向键在单元间移动，按住 Shift 每次移动十个；Enter 选取该单元的一个三角形。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::MapWords</name>
    <message>
        <source>owns no triangle</source>
        <translation>没有所属三角形</translation>
    </message>
    <message>
        <source>drawn</source>
        <translation>已绘制</translation>
    </message>
    <message>
        <source>picked</source>
        <translation>已选取</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>关闭此消息</translation>
    </message>
    <message>
        <source>All of it…</source>
        <translation>全文…</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>消息</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::MetricsModel</name>
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
        <source>Triangles that truly show in at least one pixel</source>
        <translation>至少在一个像素中真实可见的三角形</translation>
    </message>
    <message>
        <source>Submitted triangles that show in no pixel</source>
        <translation>已提交但在任何像素中都不可见的三角形</translation>
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
        <source>Submitted in vain</source>
        <translation>徒劳提交</translation>
    </message>
    <message>
        <source>Triangles of the scene of which anything is drawn, each counted once</source>
        <translation>场景中至少绘制了一部分的三角形，每个只计一次</translation>
    </message>
    <message>
        <source>– within snapping</source>
        <translation>– 对齐误差之内</translation>
    </message>
    <message>
        <source>Pixels in which the truth has a surface and this picture a farther one or none; without those within snapping</source>
        <translation>真值有表面而此图像为更远的表面或没有表面的像素；不含对齐误差之内的像素</translation>
    </message>
    <message>
        <source>Pixels that differ only because the raster snaps vertices to 1/256 pixel, which is no loss; counted where the truth draws other sides than the strategy, or the strategy makes surfaces or the picture itself</source>
        <translation>仅因光栅将顶点对齐到 1/256 像素而不同的像素，不算丢失；在真值绘制的面与策略不同，或策略自己生成表面或图像时计数</translation>
    </message>
    <message>
        <source>Speed, same sides drawn</source>
        <translation>速度，绘制相同的面</translation>
    </message>
    <message>
        <source>Frame time of the baseline that draws the same sides divided by this strategy&apos;s, measured in turns at the same camera</source>
        <translation>绘制相同面的基线的帧时间除以本策略的帧时间，在同一相机处轮流测量</translation>
    </message>
    <message>
        <source>– 95 % interval</source>
        <translation>– 95 % 区间</translation>
    </message>
    <message>
        <source>95 % interval of the speed, by bootstrap over the repeated frames of this measurement. Another start of the program can differ by more</source>
        <translation>速度的 95 % 区间，由本次测量中重复的帧经自助法得出。重新启动程序后的差异可能更大</translation>
    </message>
    <message>
        <source>Any culling, at most</source>
        <translation>任何剔除至多</translation>
    </message>
    <message>
        <source>Of the headroom</source>
        <translation>占余地的比例</translation>
    </message>
    <message>
        <source>Speed of drawing exactly the visible triangles, known beforehand, against drawing all with the same sides: what any culling could gain here at most</source>
        <translation>事先知道并只绘制可见三角形时相对于绘制相同面的全部三角形的速度：此处任何剔除至多能得到的收益</translation>
    </message>
    <message>
        <source>Share of the time saved that any culling could save, each against the baseline that draws the same sides. Below 0: slower than that baseline</source>
        <translation>已节省的时间占任何剔除可节省时间的比例，各自与绘制相同面的基线相比。低于 0：比该基线慢</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::MetricsPanel</name>
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
    <name>cullscope::ui::ObjectModel</name>
    <message>
        <source>not shown</source>
        <translation>未显示</translation>
    </message>
    <message>
        <source>verdict not known yet</source>
        <translation>判定尚未知</translation>
    </message>
    <message>
        <source>submitted</source>
        <translation>已提交</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>已显示</translation>
    </message>
    <message>
        <source>Whether it is shown</source>
        <translation>是否显示</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Diagonal of its box, scene units</source>
        <translation>包围盒对角线(场景单位)</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::Outliner</name>
    <message>
        <source>Hide</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>仅显示此项</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>全部显示</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>对准</translation>
    </message>
    <message>
        <source>Search objects</source>
        <translation>搜索物体</translation>
    </message>
    <message>
        <source>Objects of the scene</source>
        <translation>场景中的物体</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PaperTableModel</name>
    <message>
        <source>As the paper prints it</source>
        <translation>论文所印</translation>
    </message>
    <message>
        <source>Measured here</source>
        <translation>在此测得</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ParameterForm</name>
    <message>
        <source>This strategy has no parameters.</source>
        <translation>此策略没有参数。</translation>
    </message>
    <message>
        <source>As on the command line: %1</source>
        <translation>命令行中：%1</translation>
    </message>
    <message>
        <source>no file</source>
        <translation>无文件</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>选择文件</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ParetoPlot</name>
    <message>
        <source>Speed against loss</source>
        <translation>速度与损失</translation>
    </message>
    <message>
        <source>The missed pixels were not measured, so there is no loss to show.</source>
        <translation>未测量丢失像素，因此没有可显示的损失。</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <extracomment>Two figures, as the axes of a plot.</extracomment>
        <translation>%1（按 %2）</translation>
    </message>
    <message>
        <source>No strategy has both of these figures.</source>
        <translation>没有策略同时具有这两个指标。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a figure and its value</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1. Enter shows this strategy in the active view.</source>
        <translation>%1。按 Enter 在活动视图中显示此策略。</translation>
    </message>
    <message>
        <source>A click shows it in the active view.</source>
        <translation>单击可在活动视图中显示。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PathBar</name>
    <message>
        <source>● recording, poses: %1</source>
        <translation>● 正在录制，姿态：%1</translation>
    </message>
    <message>
        <source>%1 is being made…</source>
        <comment>a camera path</comment>
        <translation>正在生成 %1…</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>暂停（空格）</translation>
    </message>
    <message>
        <source>Play from here (Space)</source>
        <translation>从此处播放（空格）</translation>
    </message>
    <message>
        <source>End the recording</source>
        <translation>结束录制</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Leave the path (Esc)</source>
        <translation>离开路径（Esc）</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>a pose, number of poses</comment>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>One pose back</source>
        <translation>上一个姿态</translation>
    </message>
    <message>
        <source>One pose back (Alt+Left)</source>
        <translation>上一个姿态（Alt+Left）</translation>
    </message>
    <message>
        <source>One pose on</source>
        <translation>下一个姿态</translation>
    </message>
    <message>
        <source>One pose on (Alt+Right)</source>
        <translation>下一个姿态（Alt+Right）</translation>
    </message>
    <message>
        <source>Begin here</source>
        <translation>从此处开始</translation>
    </message>
    <message>
        <source>Leave out the poses before this one</source>
        <translation>去掉此姿态之前的姿态</translation>
    </message>
    <message>
        <source>End here</source>
        <translation>在此处结束</translation>
    </message>
    <message>
        <source>Leave out the poses after this one</source>
        <translation>去掉此姿态之后的姿态</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Take the jerks of the hand out: each pose becomes the mean of itself and its neighbours</source>
        <translation>去掉手的抖动：每个姿态成为自身与相邻姿态的平均</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>保存…</translation>
    </message>
    <message>
        <source>Save the path as a file</source>
        <translation>将路径保存为文件</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>姿态</translation>
    </message>
    <message>
        <source>Name of the path</source>
        <translation>路径的名称</translation>
    </message>
    <message>
        <source>name of the path</source>
        <translation>路径的名称</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PathCommands</name>
    <message>
        <source>Save the path</source>
        <translation>保存路径</translation>
    </message>
    <message>
        <source>Camera paths</source>
        <translation>相机路径</translation>
    </message>
    <message>
        <source>Open a path</source>
        <translation>打开路径</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PathPlot</name>
    <message>
        <source>Along the path</source>
        <translation>沿路径</translation>
    </message>
    <message>
        <source>%1: %2 a frame on average</source>
        <translation>%1：平均每帧 %2</translation>
    </message>
    <message>
        <source>Frame time in ms, by pose</source>
        <translation>各姿态的帧时间（ms）</translation>
    </message>
    <message>
        <source>Missed pixels, by pose</source>
        <translation>各姿态的丢失像素</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PictureMenu</name>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Save picture as…</source>
        <translation>图片另存为…</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PlacedPanels</name>
    <message>
        <source>Inside</source>
        <translation>内部</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>统计</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>策略</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>图例</translation>
    </message>
    <message>
        <source>Map of directions</source>
        <translation>方向映射图</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PlaneLegend</name>
    <message>
        <source>no single plane</source>
        <comment>rejected a box</comment>
        <translation>非单个平面</translation>
    </message>
    <message>
        <source>kept</source>
        <comment>a box</comment>
        <translation>保留</translation>
    </message>
    <message>
        <source>Boxes by the plane that rejected them, in objects:</source>
        <translation>按剔除平面着色的盒（物体数）：</translation>
    </message>
    <message>
        <source>%1: %2 objects</source>
        <comment>what became of a box</comment>
        <translation>%1：%2 个物体</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PlaneTable</name>
    <message>
        <source>Plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Bound</source>
        <translation>界限</translation>
    </message>
    <message>
        <source>Outside | inside</source>
        <translation>外 | 内</translation>
    </message>
    <message>
        <source>The distance in multiples of the bound, logarithmically; outside begins at the dashed line.</source>
        <translation>以界限的倍数表示的距离(对数刻度);虚线以外为外部。</translation>
    </message>
    <message>
        <source>Plane tests</source>
        <translation>平面测试</translation>
    </message>
    <message>
        <source>The strategy did not test this plane for this object; it is worked out here.</source>
        <translation>策略没有对该物体测试这个平面；数值在此计算得出。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PlotWidget</name>
    <message>
        <source>Nothing is measured yet. Choose a camera path above and press Start.</source>
        <translation>尚未测量。请在上方选择相机路径并按“开始”。</translation>
    </message>
    <message>
        <source>Being measured…</source>
        <translation>正在测量…</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PosePlot</name>
    <message>
        <source>Pose %1</source>
        <translation>姿态 %1</translation>
    </message>
    <message>
        <source>Frame: %1</source>
        <translation>帧：%1</translation>
    </message>
    <message>
        <source>Missed: %1 pixels, %2 per million</source>
        <translation>丢失：%1 像素，每百万 %2</translation>
    </message>
    <message>
        <source>Missed: not measured</source>
        <translation>丢失：未测量</translation>
    </message>
    <message>
        <source>%1, poses: %2. The arrow keys go through them, Enter flies there.</source>
        <translation>%1，姿态：%2。用方向键逐个查看，按 Enter 飞到该处。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PoseStrip</name>
    <message>
        <source>Time and loss by pose</source>
        <translation>各姿态的时间与损失</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>missed %1</source>
        <comment>a loss in parts per million</comment>
        <translation>丢失 %1</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PredictionModel</name>
    <message>
        <source>triangle %1</source>
        <translation>三角形 %1</translation>
    </message>
    <message>
        <source>vanishes</source>
        <translation>消失</translation>
    </message>
    <message>
        <source>is drawn</source>
        <translation>绘制</translation>
    </message>
    <message>
        <source>✓ right</source>
        <translation>✓ 正确</translation>
    </message>
    <message>
        <source>✗ wrong</source>
        <translation>✗ 错误</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>预期</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>实际</translation>
    </message>
    <message>
        <source>Right or wrong</source>
        <translation>对错</translation>
    </message>
    <message>
        <source>Right: %1 of %2</source>
        <translation>正确：%1 / %2</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>部分</translation>
    </message>
    <message>
        <source>in %1</source>
        <comment>a plane that divides space, in which a polygon lies</comment>
        <translation>在 %1 中</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PresenterPage</name>
    <message>
        <source>%1 · %2 since the beginning</source>
        <comment>time of day, duration</comment>
        <translation>%1 · 已进行 %2</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>现在</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>a step of a lesson, number of steps</comment>
        <translation>第 %1 步，共 %2 步</translation>
    </message>
    <message>
        <source>The lecture shows the views. Page Down goes on, R shows the figures, B blanks the screen, P points.</source>
        <translation>讲课窗口显示视图。Page Down 继续，R 显示数值，B 黑屏，P 指示。</translation>
    </message>
    <message>
        <source>This is the last step.</source>
        <translation>这是最后一步。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::QuestionBar</name>
    <message>
        <source>Click what you expect; a second click takes it back. Named: %1</source>
        <translation>点击您预期的物体；再次点击可取消。已指出：%1</translation>
    </message>
    <message>
        <source>In which order is it drawn?</source>
        <translation>按什么顺序绘制？</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Reveal</source>
        <translation>揭示</translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation>撤回</translation>
    </message>
    <message>
        <source>The active view&apos;s strategy has no leaves that could be named. Choose another strategy, other parameters, or another question.</source>
        <translation>活动视图的策略没有可指出的叶。请选择其他策略、其他参数或其他问题。</translation>
    </message>
    <message>
        <source>In which leaf does %1 lie? Then click the next part. Named: %2</source>
        <translation>%1 在哪个叶中？然后点击下一个部分。已指出：%2</translation>
    </message>
    <message>
        <source>In which leaf does it lie?</source>
        <translation>它在哪个叶中？</translation>
    </message>
    <message>
        <source>Leaf</source>
        <translation>叶</translation>
    </message>
    <message>
        <source>Click what you expect, in a view or in the tree, or drag over it with Ctrl; again takes it back. Named: %1</source>
        <translation>在视图或树中点击您预期的物体，或按住 Ctrl 拖动框选；再做一次可取消。已指出：%1</translation>
    </message>
    <message>
        <source>Click a part, then choose the leaf in which it lies, here or in the tree. Named: %1</source>
        <translation>点击一个部分，再在此处或树中选择它所在的叶。已指出：%1</translation>
    </message>
    <message>
        <source>Which objects vanish?</source>
        <translation>哪些物体会消失？</translation>
    </message>
    <message>
        <source>Which triangles vanish?</source>
        <translation>哪些三角形会消失？</translation>
    </message>
    <message>
        <source>The active view&apos;s strategy has %1 leaves here: more than %2 are not named. Choose a smaller scene or other parameters.</source>
        <translation>活动视图的策略在此有 %1 个叶：超过 %2 个则不命名。请选择更小的场景或其他参数。</translation>
    </message>
    <message>
        <source>Nothing was predicted yet: first click what you expect.</source>
        <translation>尚未作出预测：请先点击您预期的物体。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::QuestionTree</name>
    <message>
        <source>Node %1</source>
        <comment>of a strategy&apos;s tree</comment>
        <translation>节点 %1</translation>
    </message>
    <message>
        <source>A click on a row answers, too.</source>
        <translation>点击一行也可以作答。</translation>
    </message>
    <message>
        <source>Tree to answer by</source>
        <translation>用来作答的树</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ReportsDialog</name>
    <message>
        <source>Certificate</source>
        <translation>证书</translation>
    </message>
    <message>
        <source>Advice</source>
        <translation>建议</translation>
    </message>
    <message>
        <source>Worst view</source>
        <translation>最差视图</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>极端案例集</translation>
    </message>
    <message>
        <source>Judgement</source>
        <translation>评判</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Kept reports</source>
        <translation>保存的报告</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>When</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>种类</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>策略</translation>
    </message>
    <message>
        <source>What the report says</source>
        <translation>报告的内容</translation>
    </message>
    <message>
        <source>What Advice, Worst view and Stability find is kept here, beside the experiments of the statistics&apos; history.</source>
        <translation>“建议”“最差视图”和“稳定性”的结果保存在这里，与统计历史中的实验放在一起。</translation>
    </message>
    <message>
        <source>The chosen report as JSON</source>
        <translation>将所选报告保存为 JSON</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ReproduceDialog</name>
    <message>
        <source>&amp;Start</source>
        <translation>开始(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>导出(&amp;X)</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>关闭(&amp;L)</translation>
    </message>
    <message>
        <source>Reproduce a paper&apos;s table</source>
        <translation>重现论文的表</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>The paper&apos;s numbers beside ours</source>
        <translation>论文的数字与我们的数字</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>stopped early: what was measured until then</source>
        <translation>提前停止：到那时为止的测量结果</translation>
    </message>
    <message>
        <source>done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>The views show %1 at the view being measured; beside it, off the window, are measured: %2.</source>
        <translation>各视图显示正在测量的视点下的 %1；同时在窗口之外测量的还有：%2。</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>曲线图</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ResultTableModel</name>
    <message>
        <source>Strategy</source>
        <translation>策略</translation>
    </message>
    <message>
        <source>fps</source>
        <translation>fps</translation>
    </message>
    <message>
        <source>fps
least – most</source>
        <translation>fps
最低 – 最高</translation>
    </message>
    <message>
        <source>Culling of
the frame</source>
        <translation>剔除占
帧时间</translation>
    </message>
    <message>
        <source>Submitted
triangles</source>
        <translation>提交的
三角形</translation>
    </message>
    <message>
        <source>Missed
pixels</source>
        <translation>丢失
像素</translation>
    </message>
    <message>
        <source>Missed per
million</source>
        <translation>每百万
丢失</translation>
    </message>
    <message>
        <source>Worst
view</source>
        <translation>最差
视角</translation>
    </message>
    <message>
        <source>The strategy, and its parameters where they are not at their defaults</source>
        <translation>策略，以及非默认值的参数</translation>
    </message>
    <message>
        <source>Views divided by the time of all of them; a frame is cull + draw</source>
        <translation>视角数除以其总时间；一帧为剔除 + 绘制</translation>
    </message>
    <message>
        <source>In the slowest and in the fastest view</source>
        <translation>在最慢和最快的视角中</translation>
    </message>
    <message>
        <source>Share of the frame&apos;s time that goes into deciding what to draw</source>
        <translation>帧时间中用于决定绘制内容的份额</translation>
    </message>
    <message>
        <source>Share of the scene&apos;s triangles given to OpenGL, mean over the views</source>
        <translation>场景三角形中交给 OpenGL 的份额，各视角平均</translation>
    </message>
    <message>
        <source>Pixels of all views in which the truth has a surface and the strategy a farther one or none</source>
        <translation>所有视角中真值有表面而策略显示更远表面或无表面的像素</translation>
    </message>
    <message>
        <source>Missed pixels in a million pixels in which the truth has a surface</source>
        <translation>真值有表面的每百万像素中的丢失像素</translation>
    </message>
    <message>
        <source>The pose with the most missed pixels; double-click to fly there</source>
        <translation>丢失像素最多的姿态；双击飞到该处</translation>
    </message>
    <message>
        <source>It lost pixels: the promise is broken.</source>
        <translation>丢失了像素：承诺未兑现。</translation>
    </message>
    <message>
        <source>Speed against
%1 [95 %]</source>
        <comment>a strategy</comment>
        <translation>相对 %1
速度 [95 %]</translation>
    </message>
    <message>
        <source>Total time of %1 over the views divided by this strategy&apos;s, with its 95 % interval</source>
        <comment>a strategy</comment>
        <translation>%1 在各视角的总时间除以此策略的总时间，及其 95 % 区间</translation>
    </message>
    <message>
        <source>Within
snapping</source>
        <translation>对齐误差
之内</translation>
    </message>
    <message>
        <source>Pixels that differ only because the raster snaps vertices to 1/256 pixel, which is no loss; counted where the truth draws other sides than the strategy, or the strategy makes surfaces or the picture itself</source>
        <translation>仅因光栅将顶点对齐到 1/256 像素而不同的像素，不算丢失；在真值绘制的面与策略不同，或策略自己生成表面或图像时计数</translation>
    </message>
    <message>
        <source>Speed, same
sides [95 %]</source>
        <translation>速度，相同
面 [95 %]</translation>
    </message>
    <message>
        <source>Total time of the baseline that draws the same sides over the views divided by this strategy&apos;s, with its 95 % interval</source>
        <translation>绘制相同面的基线在所有视图上的总时间除以本策略的总时间，附 95 % 区间</translation>
    </message>
    <message>
        <source>The baseline: %1</source>
        <comment>a strategy</comment>
        <translation>基线：%1</translation>
    </message>
    <message>
        <source>Against %1: %2</source>
        <comment>a strategy; a ratio of times</comment>
        <translation>相对 %1：%2</translation>
    </message>
    <message>
        <source>Of the headroom
[95 %]</source>
        <translation>占余地的比例
[95 %]</translation>
    </message>
    <message>
        <source>Share of the time saved that any culling could save: what is saved where exactly the visible triangles are drawn, known beforehand. Both against the baseline that draws the same sides</source>
        <translation>已节省的时间占任何剔除可节省时间的比例：以事先知道并只绘制可见三角形时节省的时间为准。两者都与绘制相同面的基线相比</translation>
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
    <message>
        <source>– %1</source>
        <extracomment>A kind of primitive below the row of all of them, such as &quot;box&quot;.</extracomment>
        <translation>– %1</translation>
    </message>
    <message>
        <source>Primitives</source>
        <translation>基本体素</translation>
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
    <message>
        <source>Hide</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>对准</translation>
    </message>
    <message>
        <source>Brings the selected objects into the active view</source>
        <translation>把所选物体置入活动视图</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>仅显示此项</translation>
    </message>
    <message>
        <source>Hides all other objects</source>
        <translation>隐藏其他所有物体</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>全部显示</translation>
    </message>
    <message>
        <source>Split…</source>
        <translation>分割…</translation>
    </message>
    <message>
        <source>Splits the object, so that there are objects to leave out</source>
        <translation>分割物体，使策略有物体可剔除</translation>
    </message>
    <message>
        <source>chosen</source>
        <comment>the up axis</comment>
        <translation>手动选择</translation>
    </message>
    <message>
        <source>as the scene says</source>
        <comment>the up axis</comment>
        <translation>场景注明</translation>
    </message>
    <message>
        <source>guessed from its shape</source>
        <comment>the up axis</comment>
        <translation>按形状推测</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>向上轴</translation>
    </message>
    <message>
        <source>Which axis points up. The views stand anew; nothing is loaded again.</source>
        <translation>哪个轴朝上。视图会重新摆正，不会重新加载。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::SceneView</name>
    <message>
        <source>Truth</source>
        <translation>真值</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>letter of a view, strategy</comment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ScreenshotDialog</name>
    <message>
        <source>Screenshot</source>
        <translation>截图</translation>
    </message>
    <message>
        <source>View %1 alone</source>
        <translation>仅视图 %1</translation>
    </message>
    <message>
        <source>All views, as they are arranged</source>
        <translation>按布局的所有视图</translation>
    </message>
    <message>
        <source>As in the window</source>
        <translation>与窗口相同</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 像素</translation>
    </message>
    <message>
        <source>Another size</source>
        <translation>其他尺寸</translation>
    </message>
    <message>
        <source>White</source>
        <translation>白色</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>黑色</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>透明</translation>
    </message>
    <message>
        <source>&amp;Legend of the colours, with counts</source>
        <translation>带数量的颜色图例(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Caption</source>
        <translation>说明(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>浏览(&amp;B)…</translation>
    </message>
    <message>
        <source>What is saved</source>
        <translation>保存的内容</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Width in pixels</source>
        <translation>宽度（像素）</translation>
    </message>
    <message>
        <source>Height in pixels</source>
        <translation>高度（像素）</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>Text of the caption</source>
        <translation>说明文字</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>File name</source>
        <translation>文件名</translation>
    </message>
    <message>
        <source>{scene}, {strategy} and {n}, a number that no file has yet, are filled in; {n:03} has three digits. The ending chooses the format: .png, .jpg, .tif or .exr.</source>
        <translation>{scene}、{strategy} 和尚未使用的编号 {n} 会被填入；{n:03} 为三位数。扩展名决定格式：.png、.jpg、.tif 或 .exr。</translation>
    </message>
    <message>
        <source>&amp;What</source>
        <translation>内容(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>尺寸(&amp;S)</translation>
    </message>
    <message>
        <source>Back&amp;ground</source>
        <translation>背景(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation>文件夹(&amp;F)</translation>
    </message>
    <message>
        <source>File &amp;name</source>
        <translation>文件名(&amp;N)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Depth and triangle numbers are kept for one view alone.</source>
        <translation>仅单个视图会保存深度和三角形编号。</translation>
    </message>
    <message>
        <source>This format keeps no transparency: the window&apos;s background takes its place.</source>
        <translation>此格式不保存透明度：以窗口背景代替。</translation>
    </message>
    <message>
        <source>Folder for screenshots</source>
        <translation>截图文件夹</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between names of overlays</comment>
        <translation>、</translation>
    </message>
    <message>
        <source>Will be saved as %1, %2 × %3 pixels.</source>
        <translation>将保存为 %1，%2 × %3 像素。</translation>
    </message>
    <message>
        <source>Of the strategies that have them: %1</source>
        <comment>names of overlays</comment>
        <translation>部分策略特有：%1</translation>
    </message>
    <message>
        <source>&amp;Overlays: frustum, boxes, wipe, marks, the strategy&apos;s own</source>
        <translation>叠加层(&amp;O)：视锥体、包围盒、分界线、标记、策略自身的叠加层</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ScreenshotTaker</name>
    <message>
        <source>Saving the screenshot…</source>
        <translation>正在保存截图…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::SectionDialog</name>
    <message>
        <source>Clipping plane</source>
        <translation>剖切平面</translation>
    </message>
    <message>
        <source>&amp;Cut the pictures of all views</source>
        <translation>剖切所有视图的图像(&amp;C)</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>the &amp;view</source>
        <translation>视线(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Place</source>
        <translation>位置(&amp;P)</translation>
    </message>
    <message>
        <source>Place of the clipping plane</source>
        <translation>剖切平面的位置</translation>
    </message>
    <message>
        <source>Keep the &amp;other side</source>
        <translation>保留另一侧(&amp;O)</translation>
    </message>
    <message>
        <source>Culling and all figures stay those of the whole scene.</source>
        <translation>剔除和所有数据仍是整个场景的。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ShownReading</name>
    <message>
        <source>Open a scene to see what a strategy decides about it.</source>
        <translation>打开场景即可查看策略对其作出的判断。</translation>
    </message>
    <message>
        <source>The strategy is being prepared…</source>
        <translation>正在准备策略…</translation>
    </message>
    <message>
        <source>The strategy could not be built. Choose another one, or other parameters.</source>
        <translation>无法构建该策略。请选择其他策略或其他参数。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::SizeDialog</name>
    <message>
        <source>Picture size</source>
        <translation>图像大小</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::SphereMap</name>
    <message>
        <source>Loss by direction of view</source>
        <translation>各视线方向的损失</translation>
    </message>
    <message>
        <source>nothing missed</source>
        <translation>无丢失</translation>
    </message>
    <message>
        <source>%1 per million</source>
        <translation>每百万 %1</translation>
    </message>
    <message>
        <source>a tenth</source>
        <translation>十分之一</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::SplitDialog</name>
    <message>
        <source>Split the object</source>
        <translation>分割物体</translation>
    </message>
    <message>
        <source>Strategies that decide by objects have nothing to leave out in a scene of one object. What is drawn stays the same.</source>
        <translation>按物体判定的策略在只有一个物体的场景中无可剔除。绘制结果不变。</translation>
    </message>
    <message>
        <source>Components: what hangs together becomes an object</source>
        <translation>连通分量：相连的部分成为一个物体</translation>
    </message>
    <message>
        <source>Clusters: compact pieces with at most this many triangles:</source>
        <translation>簇：紧凑的小块，三角形数不超过：</translation>
    </message>
    <message>
        <source>Triangles a cluster</source>
        <translation>每簇三角形数</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>分割</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::StabilityDialog</name>
    <message>
        <source>&amp;Run all</source>
        <translation>全部运行(&amp;R)</translation>
    </message>
    <message>
        <source>Run the &amp;chosen cases</source>
        <translation>运行所选案例(&amp;C)</translation>
    </message>
    <message>
        <source>C&amp;ancel</source>
        <translation>取消(&amp;A)</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>关闭(&amp;L)</translation>
    </message>
    <message>
        <source>Stability: the battery of extreme cases</source>
        <translation>稳定性：极端案例集</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>案例</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Right answer</source>
        <translation>正确答案</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Cases with their right answers and what was found</source>
        <translation>案例及其正确答案和结果</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Double click: open %1</source>
        <translation>双击：打开 %1</translation>
    </message>
    <message>
        <source>right</source>
        <translation>正确</translation>
    </message>
    <message>
        <source>WRONG</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>control</source>
        <translation>对照</translation>
    </message>
    <message>
        <source>refuses</source>
        <translation>拒绝</translation>
    </message>
    <message>
        <source>Each case is a scene or a computation at the edge of what numbers hold, with its right answer. Run them, and see what every strategy does there; a double click opens the scene.</source>
        <translation>每个案例都是处于数值极限的场景或计算，并附正确答案。运行后可看到每个策略的表现；双击可打开场景。</translation>
    </message>
    <message>
        <source>%1 of %2 cases are wrong.</source>
        <translation>%2 个案例中有 %1 个错误。</translation>
    </message>
    <message>
        <source>All %1 cases are right.</source>
        <translation>全部 %1 个案例正确。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::StatisticsDock</name>
    <message>
        <source>Statistics</source>
        <translation>统计</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::StatisticsPanel</name>
    <message>
        <source>Open a scene: its figures appear here.</source>
        <translation>请打开场景：其数值显示在此处。</translation>
    </message>
    <message>
        <source>Nothing is measured yet. Choose a camera path above and press Start.</source>
        <translation>尚未测量。请在上方选择相机路径并按“开始”。</translation>
    </message>
    <message>
        <source>The views&apos; figures appear here as soon as they are measured.</source>
        <translation>测量完成后，各视图的数值显示在此处。</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>表格</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>姿态</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Pareto</source>
        <translation>帕累托</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>球面</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>统计</translation>
    </message>
    <message>
        <source>at the present camera</source>
        <translation>当前相机</translation>
    </message>
    <message>
        <source>of the experiment</source>
        <translation>实验结果</translation>
    </message>
    <message>
        <source>Which figures are shown</source>
        <translation>显示哪些数值</translation>
    </message>
    <message>
        <source>Strategy whose poses are shown</source>
        <translation>显示其姿态的策略</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>software OpenGL</source>
        <translation>软件 OpenGL</translation>
    </message>
    <message>
        <source>Software OpenGL: not the times of a graphics card</source>
        <translation>软件 OpenGL：不是显卡的时间</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Frames as CSV…</source>
        <translation>将各帧存为 CSV…</translation>
    </message>
    <message>
        <source>Result as JSON…</source>
        <translation>将结果存为 JSON…</translation>
    </message>
    <message>
        <source>Plot as SVG…</source>
        <translation>将图存为 SVG…</translation>
    </message>
    <message>
        <source>Plot as PDF…</source>
        <translation>将图存为 PDF…</translation>
    </message>
    <message>
        <source>Report as HTML…</source>
        <translation>将报告存为 HTML…</translation>
    </message>
    <message>
        <source>Being measured…</source>
        <translation>正在测量…</translation>
    </message>
    <message>
        <source>%1 · %2 × %3</source>
        <extracomment>A camera path and the size of the pictures.</extracomment>
        <translation>%1 · %2 × %3</translation>
    </message>
    <message>
        <source>%1 · %2 of %3 poses</source>
        <extracomment>A camera path with the size of the picture, and how many of the path&apos;s poses were measured.</extracomment>
        <translation>%1 · %3 个姿态中的 %2 个</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>Report as PDF…</source>
        <translation>报告存为 PDF…</translation>
    </message>
    <message>
        <source>Each experiment that ends appears here beside the others, also at later starts.</source>
        <translation>每个结束的实验都与其他实验并列显示在此，以后启动时也在。</translation>
    </message>
    <message>
        <source>Race</source>
        <translation>比赛</translation>
    </message>
    <message>
        <source>Each strategy against each</source>
        <translation>各策略两两比较</translation>
    </message>
    <message>
        <source>%1 is %2 times as fast as %3.</source>
        <comment>a strategy, a ratio, another strategy</comment>
        <translation>%1 的速度是 %3 的 %2 倍。</translation>
    </message>
    <message>
        <source>It takes %1 ms less a view (95 %: %2 to %3).</source>
        <translation>每个视图少用 %1 ms（95 %：%2 至 %3）。</translation>
    </message>
    <message>
        <source>It takes %1 ms less a view.</source>
        <translation>每个视图少用 %1 ms。</translation>
    </message>
    <message>
        <source>It misses %1 of a million pixels more.</source>
        <translation>每百万像素多丢失 %1 个。</translation>
    </message>
    <message>
        <source>The interval holds 1: which one is faster is not decided.</source>
        <translation>区间包含 1：无法确定哪个更快。</translation>
    </message>
    <message>
        <source>Figure across</source>
        <translation>横轴指标</translation>
    </message>
    <message>
        <source>Figure upwards</source>
        <translation>纵轴指标</translation>
    </message>
    <message>
        <source>→ %1</source>
        <translation>→ %1</translation>
    </message>
    <message>
        <source>↑ %1</source>
        <translation>↑ %1</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Which columns the table shows</source>
        <translation>表格显示哪些列</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>How many times as fast as the column&apos;s strategy the row&apos;s is, and how many milliseconds a view it takes less (−) or more (+), each with its 95 % interval. Bold: faster for certain; ≈: not decided.</source>
        <translation>行中策略的速度是列中策略的多少倍，以及每个视图少用（−）或多用（+）多少毫秒，均附 95 % 区间。粗体：确定更快；≈：未定。</translation>
    </message>
    <message>
        <source>Each strategy is held against each other one as soon as an experiment has ended.</source>
        <translation>实验结束后，各策略将两两比较。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::StepBar</name>
    <message>
        <source>%1 of %2</source>
        <comment>a step, number of steps</comment>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>place, size of the steps</comment>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>by subject</source>
        <translation>按物体</translation>
    </message>
    <message>
        <source>by object</source>
        <translation>按物体</translation>
    </message>
    <message>
        <source>by command</source>
        <translation>按命令</translation>
    </message>
    <message>
        <source>in equal parts</source>
        <translation>等分</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Play from here</source>
        <translation>从此处播放</translation>
    </message>
    <message>
        <source>The strategy&apos;s decisions are being read…</source>
        <translation>正在读取策略的决定…</translation>
    </message>
    <message>
        <source>Breakpoints</source>
        <translation>断点</translation>
    </message>
    <message>
        <source>Breakpoints: %1</source>
        <translation>断点：%1</translation>
    </message>
    <message>
        <source>Each step is one decision or command of the frame.</source>
        <translation>每一步是该帧的一个决定或命令。</translation>
    </message>
    <message>
        <source>This frame has %1 decisions and commands: each step takes several of them.</source>
        <translation>该帧有 %1 个决定和命令：每一步包含其中若干个。</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>kind of decision, how many</comment>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>To the start (Shift+Page Up)</source>
        <translation>到开头（Shift+Page Up）</translation>
    </message>
    <message>
        <source>One step back (Page Up)</source>
        <translation>后退一步（Page Up）</translation>
    </message>
    <message>
        <source>One step on (Page Down)</source>
        <translation>前进一步（Page Down）</translation>
    </message>
    <message>
        <source>To the end (Shift+Page Down)</source>
        <translation>到末尾（Shift+Page Down）</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步</translation>
    </message>
    <message>
        <source>Steps a second:</source>
        <translation>每秒步数：</translation>
    </message>
    <message>
        <source>Playing stops at decisions of these kinds; Ctrl+Page Down and Ctrl+Page Up go to the next and the last one</source>
        <translation>播放会停在这些类型的决定处；Ctrl+Page Down 和 Ctrl+Page Up 跳到下一个和上一个</translation>
    </message>
    <message>
        <source>Show the whole frame again (F8)</source>
        <translation>重新显示整帧（F8）</translation>
    </message>
    <message>
        <source>The method itself records this frame coarser:</source>
        <translation>该方法本身对此帧的记录较粗：</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::Stepper</name>
    <message>
        <source>Nothing was decided and nothing was drawn yet.</source>
        <translation>尚未作出任何决定，也未绘制任何内容。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>subject of a decision, what was found</comment>
        <translation>%1：%2</translation>
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
    <name>cullscope::ui::StructureModel</name>
    <message>
        <source>Node %1</source>
        <comment>of a tree of boxes</comment>
        <translation>节点 %1</translation>
    </message>
    <message>
        <source>kept</source>
        <comment>a box that holds others</comment>
        <translation>保留</translation>
    </message>
    <message>
        <source>submitted</source>
        <translation>已提交</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Rejected by</source>
        <translation>被何平面排除</translation>
    </message>
    <message>
        <source>1 object</source>
        <comment>a group of one</comment>
        <translation>1 个物体</translation>
    </message>
    <message>
        <source>%1 objects</source>
        <comment>a group of so many</comment>
        <translation>%1 个物体</translation>
    </message>
    <message>
        <source>%1: %2 triangles</source>
        <comment>an object or a group</comment>
        <translation>%1：%2 个三角形</translation>
    </message>
    <message>
        <source>no single plane</source>
        <comment>has a group outside</comment>
        <translation>非单个平面</translation>
    </message>
    <message>
        <source>%1: %2 objects</source>
        <comment>a group by its name</comment>
        <translation>%1：%2 个物体</translation>
    </message>
    <message>
        <source>all %1</source>
        <comment>a box whose parts were left out for one cause</comment>
        <translation>全部%1</translation>
    </message>
    <message>
        <source>all left out</source>
        <comment>the parts of a box</comment>
        <translation>全部剔除</translation>
    </message>
    <message>
        <source>partly kept</source>
        <comment>a box that holds others</comment>
        <translation>部分保留</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::StructurePanel</name>
    <message>
        <source>Inside the strategy</source>
        <translation>策略内部</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>树</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Losses</source>
        <translation>丢失</translation>
    </message>
    <message>
        <source>Listing</source>
        <translation>代码</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>计数</translation>
    </message>
    <message>
        <source>Chart</source>
        <comment>a tab: a flow chart</comment>
        <translation>流程图</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::StructureTree</name>
    <message>
        <source>Boxes that the strategy tests</source>
        <translation>策略测试的包围盒</translation>
    </message>
    <message>
        <source>This strategy tests no boxes. Strategies that test bounds or descend a tree list them here, with what they decided about each.</source>
        <translation>该策略不测试包围盒。测试包围体或遍历树的策略会在此列出它们以及对每个的判定。</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::SweepWords</name>
    <message>
        <source>auto</source>
        <comment>a parameter&apos;s value that a strategy chooses</comment>
        <translation>自动</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <extracomment>A strategy and the parameter that is varied, as in &quot;spherical by rows&quot;.</extracomment>
        <translation>%1，按 %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>what is varied, its values</comment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::TimeBar</name>
    <message>
        <source>Time of a frame</source>
        <translation>一帧的时间</translation>
    </message>
    <message>
        <source>%1 = %2 cull + %3 draw</source>
        <extracomment>A frame&apos;s time: total = culling + drawing</extracomment>
        <translation>%1 = 剔除 %2 + 绘制 %3</translation>
    </message>
    <message>
        <source>cull</source>
        <translation>剔除</translation>
    </message>
    <message>
        <source>draw</source>
        <translation>绘制</translation>
    </message>
    <message>
        <source>grey: %1 and %2</source>
        <comment>two strategies</comment>
        <translation>灰色：%1 和 %2</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::UndoRecorder</name>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>撤销：%1</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>重做：%1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::UndoStep</name>
    <message>
        <source>hidden objects</source>
        <translation>隐藏的物体</translation>
    </message>
    <message>
        <source>camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>camera of view %1</source>
        <translation>视图 %1 的相机</translation>
    </message>
    <message>
        <source>several changes</source>
        <translation>多项更改</translation>
    </message>
    <message>
        <source>strategy of view %1</source>
        <translation>视图 %1 的策略</translation>
    </message>
    <message>
        <source>parameters of view %1</source>
        <translation>视图 %1 的参数</translation>
    </message>
    <message>
        <source>display of view %1</source>
        <translation>视图 %1 的显示</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ViewCommands</name>
    <message>
        <source>Copy the picture</source>
        <translation>复制图像</translation>
    </message>
    <message>
        <source>Copy the picture without what lies over it</source>
        <translation>复制不带叠加层的图像</translation>
    </message>
    <message>
        <source>Copy the cullbench command</source>
        <translation>复制 cullbench 命令</translation>
    </message>
    <message>
        <source>Object %1</source>
        <comment>its name</comment>
        <translation>物体 %1</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>对准</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>仅显示此项</translation>
    </message>
    <message>
        <source>Show all hidden objects</source>
        <translation>显示所有隐藏的物体</translation>
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
    <message>
        <source>What view %1 shows, and how</source>
        <translation>视图 %1 显示的内容和方式</translation>
    </message>
    <message>
        <source>watches %1</source>
        <comment>letter of a view</comment>
        <translation>观察 %1</translation>
    </message>
    <message>
        <source>frozen</source>
        <translation>已冻结</translation>
    </message>
    <message>
        <source>What do you expect? The figures come with the answer.</source>
        <translation>您预期什么？数字随答案显示。</translation>
    </message>
    <message>
        <source>step %1 of %2 · whole frame: %3</source>
        <translation>第 %1 / %2 步 · 整帧：%3</translation>
    </message>
    <message>
        <source>step %1 · %2</source>
        <comment>of a narrow view, figures</comment>
        <translation>第 %1 步 · %2</translation>
    </message>
    <message>
        <source>%1 · at %2 %</source>
        <comment>size, percent</comment>
        <extracomment>Of a picture: its size in pixels, and how large the window shows it.</extracomment>
        <translation>%1 · 按 %2 % 显示</translation>
    </message>
    <message>
        <source>Picture and figures: %1 pixels, which fit the window: figures change with it</source>
        <translation>图像与数据：%1 像素，适应窗口：数据随窗口改变</translation>
    </message>
    <message>
        <source>Picture and figures: %1 pixels, shown at %2 %; figures do not change with the window</source>
        <translation>图像与数据：%1 像素，按 %2 % 显示；数据不随窗口改变</translation>
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
    <message>
        <source>culling frozen (F)</source>
        <translation>剔除已冻结 (F)</translation>
    </message>
    <message>
        <source>vertex arrays</source>
        <translation>顶点数组</translation>
    </message>
    <message>
        <source>%1 pixels differ from view %2</source>
        <translation>有 %1 个像素与视图 %2 不同</translation>
    </message>
    <message>
        <source>hidden objects: %1</source>
        <translation>隐藏的物体：%1</translation>
    </message>
    <message>
        <source>loss %1 of %2, pixels: %3</source>
        <translation>丢失 %1/%2，像素：%3</translation>
    </message>
    <message>
        <source>visible triangles in both: %1, only here: %2, only in view %3: %4</source>
        <translation>两者都可见的三角形：%1，仅此处：%2，仅视图 %3：%4</translation>
    </message>
    <message>
        <source>missed pixels: %1, nearer than the truth: %2</source>
        <translation>丢失的像素：%1，比真值更近的像素：%2</translation>
    </message>
    <message>
        <source>missed pixels: %1, within snapping and not lost: %2, nearer than the truth: %3</source>
        <translation>丢失的像素：%1，对齐误差之内、未丢失的像素：%2，比真值更近的像素：%3</translation>
    </message>
    <message>
        <source>difference within snapping %1 of %2, pixels: %3</source>
        <translation>对齐误差之内的差异 %1/%2，像素：%3</translation>
    </message>
    <message>
        <source>nothing in view: Home</source>
        <translation>视野中没有东西：Home</translation>
    </message>
    <message>
        <source>flying speed × %1 ([ and ])</source>
        <translation>飞行速度 × %1（[ 和 ]）</translation>
    </message>
    <message>
        <source>wireframe; figures of the filled picture</source>
        <translation>线框；数值为填充图像的数值</translation>
    </message>
    <message>
        <source>coarse while it moves: %1 of %2 triangles, by object</source>
        <translation>移动时为粗略图像：%2 个三角形中的 %1 个，按物体</translation>
    </message>
    <message>
        <source>parallel, height %1</source>
        <translation>平行投影，高度 %1</translation>
    </message>
    <message>
        <source>cut by a plane; figures of the whole scene</source>
        <translation>被平面剖切；数据为整个场景的</translation>
    </message>
    <message>
        <source>coarse while it moves: %1 of %2 triangles, by object; what lies outside as boxes</source>
        <translation>移动时为粗略图像：%2 个三角形中的 %1 个，按物体；视锥体外的用包围盒</translation>
    </message>
    <message>
        <source>difference %1 of %2, pixels: %3</source>
        <translation>差异 %1/%2，像素：%3</translation>
    </message>
    <message>
        <source>missing up to this step, pixels: %1, nearer than the truth: %2</source>
        <translation>到此步为止缺少的像素：%1，比真值更近的像素：%2</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::WhyPanel</name>
    <message>
        <source>Click on something in a picture to see why it was drawn or left out.</source>
        <translation>点击画面中的任意处，查看它为何被绘制或被剔除。</translation>
    </message>
    <message>
        <source>The picked object is hidden by you. Show it again to see why the strategy draws it or leaves it out.</source>
        <translation>所选物体已被您隐藏。重新显示它即可查看策略为何绘制或剔除它。</translation>
    </message>
    <message>
        <source>Why the picked triangle was drawn or left out</source>
        <translation>所选三角形被绘制或剔除的原因</translation>
    </message>
    <message>
        <source>The strategy&apos;s decisions are being read…</source>
        <translation>正在读取策略的判定…</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <comment>number of a step, its sentence</comment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Whether it is visible is not known yet.</source>
        <translation>尚不知它是否可见。</translation>
    </message>
    <message>
        <source>%1, triangle %2</source>
        <comment>name of an object</comment>
        <translation>%1,三角形 %2</translation>
    </message>
    <message>
        <source>It shows in the picture.</source>
        <translation>它在图像中可见。</translation>
    </message>
    <message>
        <source>It was drawn in vain: other triangles lie before all of it, or it covers no pixel&apos;s middle.</source>
        <translation>它被徒劳绘制：其他三角形完全遮住了它，或它没有覆盖任何像素的中心。</translation>
    </message>
    <message>
        <source>It was wrongly left out: the truth shows it.</source>
        <translation>它被误剔除：真值中可以看到它。</translation>
    </message>
    <message>
        <source>In grey: not tested by the strategy for this object alone; worked out here from its own box.</source>
        <translation>灰色：策略没有单独对该物体测试；在此由其自身的盒计算得出。</translation>
    </message>
    <message>
        <source>drawn, or decided to be drawn</source>
        <translation>已绘制，或已决定绘制</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <comment>state of a triangle, the sentence that says what decided</comment>
        <translation>%1。%2</translation>
    </message>
    <message>
        <source>%1 from the point picked before (x %2, y %3, z %4)</source>
        <comment>a length, and its components along the axes</comment>
        <translation>距上次选取的点 %1（x %2，y %3，z %4）</translation>
    </message>
    <message>
        <source>Left out, within the raster&apos;s snapping</source>
        <translation>已剔除，差异在光栅对齐之内</translation>
    </message>
    <message>
        <source>The truth shows it where the raster&apos;s rounding of corners to 1/256 pixel explains the difference: no pixel is lost.</source>
        <translation>真值中可见，但该差异可由光栅将角点取整到 1/256 像素来解释：没有丢失像素。</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>two sentences</comment>
        <translation>%1 %2</translation>
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
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Picture</source>
        <translation>图像(&amp;P)</translation>
    </message>
    <message>
        <source>P&amp;ath</source>
        <translation>路径(&amp;A)</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>打开最近的文件(&amp;R)</translation>
    </message>
    <message>
        <source>Open a mesh file, a session, or a picture that Cullscope took</source>
        <translation>打开网格文件、会话或 Cullscope 截取的图像</translation>
    </message>
    <message>
        <source>&amp;Save the session</source>
        <translation>保存会话(&amp;S)</translation>
    </message>
    <message>
        <source>Save scene, views, strategies and cameras as a file</source>
        <translation>将场景、视图、策略和相机保存为文件</translation>
    </message>
    <message>
        <source>Save the session &amp;as…</source>
        <translation>会话另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Save the session under another name</source>
        <translation>以其他名称保存会话</translation>
    </message>
    <message>
        <source>S&amp;creenshot…</source>
        <translation>截图(&amp;C)…</translation>
    </message>
    <message>
        <source>Save a picture of the views: size, format, legend, background</source>
        <translation>保存视图的图像：尺寸、格式、图例、背景</translation>
    </message>
    <message>
        <source>Screenshot a&amp;gain</source>
        <translation>再次截图(&amp;G)</translation>
    </message>
    <message>
        <source>Save a picture as the last time</source>
        <translation>按上次的设置保存图像</translation>
    </message>
    <message>
        <source>Screenshot &amp;without overlays</source>
        <translation>不带叠加层的截图(&amp;W)</translation>
    </message>
    <message>
        <source>Save a picture of what was drawn and nothing over it</source>
        <translation>仅保存绘制的内容</translation>
    </message>
    <message>
        <source>Camera &amp;bookmarks</source>
        <translation>相机书签(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>面板(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;4 views</source>
        <translation>4 个视图(&amp;4)</translation>
    </message>
    <message>
        <source>Compare four views</source>
        <translation>比较四个视图</translation>
    </message>
    <message>
        <source>&amp;8 views</source>
        <translation>8 个视图(&amp;8)</translation>
    </message>
    <message>
        <source>Compare eight views</source>
        <translation>比较八个视图</translation>
    </message>
    <message>
        <source>&amp;Lecture</source>
        <translation>讲课(&amp;L)</translation>
    </message>
    <message>
        <source>Show the active view full screen, large enough for the back row</source>
        <translation>全屏显示活动视图，后排也能看清</translation>
    </message>
    <message>
        <source>&amp;Reset the layout</source>
        <translation>重置布局(&amp;R)</translation>
    </message>
    <message>
        <source>Put all panels back to their places</source>
        <translation>将所有面板放回原位</translation>
    </message>
    <message>
        <source>&amp;Freeze culling</source>
        <translation>冻结剔除(&amp;F)</translation>
    </message>
    <message>
        <source>The culling camera stands while you fly on in the active view</source>
        <translation>在活动视图中继续飞行时剔除相机保持不动</translation>
    </message>
    <message>
        <source>Wipe: &amp;truth | strategy</source>
        <translation>对比：真值 | 策略(&amp;T)</translation>
    </message>
    <message>
        <source>Put the truth beside the strategy&apos;s picture; drag the line</source>
        <translation>将真值放在策略图像旁边；拖动分界线</translation>
    </message>
    <message>
        <source>&amp;Missed pixels</source>
        <translation>丢失的像素(&amp;M)</translation>
    </message>
    <message>
        <source>Mark the pixels that the strategy missed or added</source>
        <translation>标记策略丢失或多出的像素</translation>
    </message>
    <message>
        <source>&amp;Next loss</source>
        <translation>下一处损失(&amp;N)</translation>
    </message>
    <message>
        <source>Go to the next lost pixels, largest hole first</source>
        <translation>转到下一处丢失的像素，最大的空洞优先</translation>
    </message>
    <message>
        <source>&amp;Loupe</source>
        <translation>放大镜(&amp;L)</translation>
    </message>
    <message>
        <source>Enlarge what is under the pointer</source>
        <translation>放大指针下的内容</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>录制(&amp;R)</translation>
    </message>
    <message>
        <source>Record the camera&apos;s moves as a path</source>
        <translation>将相机的移动录制为路径</translation>
    </message>
    <message>
        <source>&amp;Add this pose</source>
        <translation>添加此姿态(&amp;A)</translation>
    </message>
    <message>
        <source>Add the present camera to the path</source>
        <translation>将当前相机添加到路径</translation>
    </message>
    <message>
        <source>&amp;Save the path…</source>
        <translation>保存路径(&amp;S)…</translation>
    </message>
    <message>
        <source>Save the recorded path as a file</source>
        <translation>将录制的路径保存为文件</translation>
    </message>
    <message>
        <source>&amp;Open a path…</source>
        <translation>打开路径(&amp;O)…</translation>
    </message>
    <message>
        <source>Open a camera path to play it</source>
        <translation>打开相机路径以播放</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>播放(&amp;P)</translation>
    </message>
    <message>
        <source>Play the path, a picture of every view at every pose</source>
        <translation>播放路径，每个姿态绘制每个视图</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>停止(&amp;T)</translation>
    </message>
    <message>
        <source>Stop recording and playing</source>
        <translation>停止录制和播放</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>坐标轴(&amp;X)</translation>
    </message>
    <message>
        <source>Show the axes in a corner of each view; a click on an end looks from there</source>
        <translation>在每个视图的角落显示坐标轴；单击端点则从该方向观察</translation>
    </message>
    <message>
        <source>What the views, panels and figures mean</source>
        <translation>视图、面板和数值的含义</translation>
    </message>
    <message>
        <source>Repro&amp;duce a paper&apos;s table…</source>
        <translation>重现论文的表(&amp;D)…</translation>
    </message>
    <message>
        <source>Measure what a paper&apos;s table shows, in the paper&apos;s windows, and put its numbers beside ours</source>
        <translation>按论文的窗口测量论文表中的内容，并把它的数字与我们的并列</translation>
    </message>
    <message>
        <source>Not while the view shows the model in spherical coordinates: what a camera sees has no place there</source>
        <translation>视图以球坐标显示模型时不可用：相机所见的内容在其中没有位置</translation>
    </message>
    <message>
        <source>S&amp;tep through</source>
        <translation>逐步查看(&amp;T)</translation>
    </message>
    <message>
        <source>Replay the active view&apos;s frame step by step, with what the strategy decides</source>
        <translation>逐步重放当前视图的帧，并显示策略的决定</translation>
    </message>
    <message>
        <source>&amp;Question first</source>
        <translation>先提问(&amp;Q)</translation>
    </message>
    <message>
        <source>Hide figures and verdicts until what the audience expects was clicked, then reveal both beside each other</source>
        <translation>隐藏数字和判定，直到点击了观众的预期，再并排揭示</translation>
    </message>
    <message>
        <source>One step on</source>
        <translation>前进一步</translation>
    </message>
    <message>
        <source>One step back</source>
        <translation>后退一步</translation>
    </message>
    <message>
        <source>To the first step</source>
        <translation>到第一步</translation>
    </message>
    <message>
        <source>To the last step</source>
        <translation>到最后一步</translation>
    </message>
    <message>
        <source>On to the next breakpoint</source>
        <translation>到下一个断点</translation>
    </message>
    <message>
        <source>Back to the last breakpoint</source>
        <translation>回到上一个断点</translation>
    </message>
    <message>
        <source>One pose o&amp;n</source>
        <translation>下一个姿态(&amp;N)</translation>
    </message>
    <message>
        <source>Show the next pose of the path, without measuring</source>
        <translation>显示路径的下一个姿态，不测量</translation>
    </message>
    <message>
        <source>Show the pose before, without measuring</source>
        <translation>显示前一个姿态，不测量</translation>
    </message>
    <message>
        <source>&amp;Built-in paths</source>
        <translation>内置路径(&amp;B)</translation>
    </message>
    <message>
        <source>One pose bac&amp;k</source>
        <translation>上一个姿态(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Lessons</source>
        <translation>课程(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Open a lesson…</source>
        <translation>打开课程(&amp;O)…</translation>
    </message>
    <message>
        <source>Open a lesson&apos;s file</source>
        <translation>打开课程文件</translation>
    </message>
    <message>
        <source>&amp;Add as step…</source>
        <translation>添加为一步(&amp;A)…</translation>
    </message>
    <message>
        <source>Add what the window shows to a lesson of your own</source>
        <translation>把窗口所示添加到自己的课程</translation>
    </message>
    <message>
        <source>&amp;Handout…</source>
        <translation>讲义(&amp;H)…</translation>
    </message>
    <message>
        <source>Save all steps of the lesson as a PDF or HTML file: picture, sentence and figures</source>
        <translation>把课程的所有步骤存为 PDF 或 HTML 文件：图像、句子和数值</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>Go on to the lesson&apos;s next step</source>
        <translation>前往课程的下一步</translation>
    </message>
    <message>
        <source>Step before</source>
        <translation>上一步</translation>
    </message>
    <message>
        <source>Go back to the lesson&apos;s step before</source>
        <translation>返回课程的上一步</translation>
    </message>
    <message>
        <source>First step</source>
        <translation>第一步</translation>
    </message>
    <message>
        <source>Go to the lesson&apos;s first step</source>
        <translation>前往课程的第一步</translation>
    </message>
    <message>
        <source>Last step</source>
        <translation>最后一步</translation>
    </message>
    <message>
        <source>Go to the lesson&apos;s last step</source>
        <translation>前往课程的最后一步</translation>
    </message>
    <message>
        <source>&amp;Leave the lesson</source>
        <translation>退出课程(&amp;L)</translation>
    </message>
    <message>
        <source>Leave the lesson: what is shown stays</source>
        <translation>退出课程：所示内容保留</translation>
    </message>
    <message>
        <source>&amp;6 views</source>
        <translation>6 个视图(&amp;6)</translation>
    </message>
    <message>
        <source>Compare six views: three columns</source>
        <translation>比较六个视图：三列</translation>
    </message>
    <message>
        <source>&amp;Watch from outside</source>
        <translation>从外部观察(&amp;W)</translation>
    </message>
    <message>
        <source>Another view shows from outside what the active view culls; again: it is linked</source>
        <translation>另一视图从外部显示活动视图的剔除；再按一次则恢复联动</translation>
    </message>
    <message>
        <source>Look &amp;from</source>
        <translation>观看方向(&amp;F)</translation>
    </message>
    <message>
        <source>Picture si&amp;ze</source>
        <translation>图像大小(&amp;Z)</translation>
    </message>
    <message>
        <source>Pro&amp;jection</source>
        <translation>投影(&amp;J)</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>透视(&amp;P)</translation>
    </message>
    <message>
        <source>Lines of sight meet in the eye: what is farther is smaller</source>
        <translation>视线交于视点：越远越小</translation>
    </message>
    <message>
        <source>P&amp;arallel</source>
        <translation>平行(&amp;A)</translation>
    </message>
    <message>
        <source>Lines of sight run side by side: sizes do not depend on the distance (orthographic)</source>
        <translation>视线彼此平行：大小与距离无关（正交投影）</translation>
    </message>
    <message>
        <source>Clippin&amp;g plane…</source>
        <translation>剖切平面(&amp;G)…</translation>
    </message>
    <message>
        <source>Cut the pictures by a plane, to look inside: a section</source>
        <translation>用平面剖切图像以观察内部：剖面</translation>
    </message>
    <message>
        <source>Sta&amp;bility…</source>
        <translation>稳定性(&amp;B)…</translation>
    </message>
    <message>
        <source>Run the battery of extreme cases, and open their scenes</source>
        <translation>运行极端案例集，并打开其场景</translation>
    </message>
    <message>
        <source>Dra&amp;w a paper&apos;s figure…</source>
        <translation>绘制论文的插图(&amp;W)…</translation>
    </message>
    <message>
        <source>Draw a figure of a paper anew, and save it as a picture or as its numbers</source>
        <translation>重新绘制论文的插图，并保存为图片或数据</translation>
    </message>
    <message>
        <source>Adv&amp;ise…</source>
        <translation>建议(&amp;I)…</translation>
    </message>
    <message>
        <source>Measure which strategy suits this scene, what it would lose, and what it costs</source>
        <translation>测量哪种策略适合此场景、会丢失什么以及代价</translation>
    </message>
    <message>
        <source>W&amp;orst view…</source>
        <translation>最差视图(&amp;O)…</translation>
    </message>
    <message>
        <source>Search for the view in which the active view&apos;s strategy loses most or gains least</source>
        <translation>搜索活动视图的策略丢失最多或收益最小的视图</translation>
    </message>
    <message>
        <source>&amp;Kept reports…</source>
        <translation>保存的报告(&amp;K)…</translation>
    </message>
    <message>
        <source>The advice, worst views, runs of the battery and certificates of the result store</source>
        <translation>结果存储中的建议、最差视图、极端案例集的运行和证书</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::WorstDialog</name>
    <message>
        <source>&amp;Search</source>
        <translation>搜索(&amp;S)</translation>
    </message>
    <message>
        <source>C&amp;ancel</source>
        <translation>取消(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Go to the worst view</source>
        <translation>转到最差视图(&amp;G)</translation>
    </message>
    <message>
        <source>Sa&amp;ve the map…</source>
        <translation>保存地图(&amp;V)…</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>关闭(&amp;L)</translation>
    </message>
    <message>
        <source>The worst view of a strategy</source>
        <translation>策略的最差视图</translation>
    </message>
    <message>
        <source>that loses most</source>
        <translation>丢失最多的视图</translation>
    </message>
    <message>
        <source>that gains least</source>
        <translation>收益最小的视图</translation>
    </message>
    <message>
        <source>What is sought</source>
        <translation>搜索目标</translation>
    </message>
    <message>
        <source>from around the scene</source>
        <translation>从场景周围</translation>
    </message>
    <message>
        <source>from places within the scene</source>
        <translation>从场景内部的位置</translation>
    </message>
    <message>
        <source>Where the eye is</source>
        <translation>视点位置</translation>
    </message>
    <message>
        <source>views: </source>
        <translation>视图：</translation>
    </message>
    <message>
        <source>How many views are tried at most</source>
        <translation>最多尝试的视图数</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Views are being tried, the worst parts of the map again and again in smaller parts…</source>
        <translation>正在尝试各视图，地图上最差的部分会一再细分…</translation>
    </message>
    <message>
        <source>The active view&apos;s strategy is drawn in many views, and the worst ones are searched more closely. A click on the map flies there.</source>
        <translation>在许多视图中绘制活动视图的策略，并对最差处作更细的搜索。单击地图可转到该处。</translation>
    </message>
    <message>
        <source>Save the map</source>
        <translation>保存地图</translation>
    </message>
    <message>
        <source>Pictures (*.svg *.pdf *.png)</source>
        <translation>图片 (*.svg *.pdf *.png)</translation>
    </message>
</context>
</TS>
